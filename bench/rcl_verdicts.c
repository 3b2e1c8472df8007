/* Ask the real rcl_yaml_param_parser whether it takes parameter files: one path a line in, "ok" or "ERR why" out.
 *
 * Build it against rcl, rcutils, rmw (sources of ros2/rcl, ros2/rcutils, ros2/rmw side by side) and libyaml:
 *   gcc -w -D_GNU_SOURCE -o rcl_verdicts rcl_verdicts.c rcl/rcl_yaml_param_parser/src/[a-z]*.c \
 *     rcutils/src/{allocator,error_handling,strdup,format_string,string_array,snprintf}.c \
 *     rmw/rmw/src/validate_{namespace,node_name,full_topic_name}.c \
 *     -Ircl/rcl_yaml_param_parser/include -Ircutils/include -Irmw/rmw/include -lyaml
 */
#include <stdio.h>
#include <string.h>

#include "rcl_yaml_param_parser/parser.h"
#include "rcutils/allocator.h"
#include "rcutils/error_handling.h"

int main(void)
{
  char line[4096];
  while (fgets(line, sizeof line, stdin)) {
    line[strcspn(line, "\n")] = 0;
    rcl_params_t * params = rcl_yaml_node_struct_init(rcutils_get_default_allocator());
    if (rcl_parse_yaml_file(line, params)) {
      puts("ok");
    } else {
      char why[2000];
      snprintf(why, sizeof why, "%s", rcutils_get_error_string().str);
      for (char * c = why; *c; ++c) {
        if (*c == '\n') {
          *c = ' ';
        }
      }
      printf("ERR %s\n", why);
      rcutils_reset_error();
    }
    fflush(stdout);
  }
  return 0;
}
