# frames: functions whose stack frame is larger than `limit` bytes or not known, from gcc's -fstack-usage; status 1 if any.
#
#     awk -v limit=256 -f frames.awk FILE.su
BEGIN { FS = "\t" }
$2 > most { most = $2 }
$2 > limit || $3 ~ /dynamic$/ { print $1 ": " $2 " bytes, " $3; bad = 1 }
END { print "largest frame: " most " bytes"; exit bad }
