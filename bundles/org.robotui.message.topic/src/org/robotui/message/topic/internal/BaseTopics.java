package org.robotui.message.topic.internal;

import java.util.Collection;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.robotui.data.command.VelocityCommand;
import org.robotui.message.data.CommandType;

/**
 * The topics that move the base, among all that take velocities (an arm that is servoed, a camera, the inputs of a
 * multiplexer): those named {@code cmd_vel} with the fewest parts before; where nothing has that name, all of them.
 */
record BaseTopics(Set<String> topics) implements Predicate<String> {
  private static final String NAME = "/cmd_vel";

  /** Of topics that take commands, with their types. */
  static BaseTopics of(Map<String, String> taken) {
    Set<String> velocities = taken.entrySet().stream()
        .filter(e -> CommandType.of(e.getValue()).filter(c -> c.data() == VelocityCommand.class).isPresent())
        .map(Map.Entry::getKey).collect(Collectors.toSet());
    Set<String> named = velocities.stream().filter(t -> t.endsWith(NAME)).collect(Collectors.toSet());
    return new BaseTopics(named.isEmpty() ? velocities : outermost(named));
  }

  private static Set<String> outermost(Collection<String> topics) {
    long fewest = topics.stream().mapToLong(BaseTopics::depth).min().orElse(0);
    return topics.stream().filter(t -> depth(t) == fewest).collect(Collectors.toSet());
  }

  private static long depth(String topic) {
    return topic.chars().filter(c -> c == '/').count();
  }

  @Override
  public boolean test(String topic) {
    return topics.contains(topic);
  }
}
