/* The commands of the program: each takes the whole command line and gives the exit status. */
#ifndef STONEPACK_HOST_COMMANDS_H
#define STONEPACK_HOST_COMMANDS_H

int command_check(int argc, char **argv);
int command_limit(int argc, char **argv);
int command_verify(int argc, char **argv);
int command_cost(int argc, char **argv);
int command_qp(int argc, char **argv);
int command_sequence(int argc, char **argv);
int command_contacts(int argc, char **argv);
int command_convert(int argc, char **argv);
int command_settle(int argc, char **argv);
int command_worker(int argc, char **argv);
int command_plan(int argc, char **argv);
int command_gen(int argc, char **argv);

#endif
