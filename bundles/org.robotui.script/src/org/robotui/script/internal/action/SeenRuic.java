package org.robotui.script.internal.action;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Ruic;
import org.robotui.api.layout.Arrangement;

/**
 * What a user can change of a robot UI, at one moment.
 *
 * @param views how they lie
 * @param perspective the chosen one
 * @param selected the robots of a team that are selected
 * @param robots by name
 */
record SeenRuic(Arrangement views, Optional<String> perspective, List<String> selected, Map<String, Hold> robots) {

  /**
   * What a user has of a robot.
   *
   * @param control whether a user has control
   * @param stopped whether a user has stopped it
   */
  record Hold(boolean control, boolean stopped) {}

  static SeenRuic of(Ruic ruic) {
    return new SeenRuic(ruic.arranging().now(), ruic.arranging().perspective(), List.copyOf(ruic.selection().robots()),
        ruic.authorities().stream()
            .collect(Collectors.toMap(Authority::robot, SeenRuic::hold, (first, second) -> first)));
  }

  private static Hold hold(Authority robot) {
    Predicate<Principal> user = by -> by.kind() != Principal.Kind.SCRIPT;
    return new Hold(robot.holder().filter(user).isPresent(), robot.stoppedBy().filter(user).isPresent());
  }

  /** The robots of which something is true that was not before. */
  List<String> begun(SeenRuic before, Function<Hold, Boolean> what) {
    return robots.keySet().stream().filter(r -> what.apply(hold(r)) && !what.apply(before.hold(r))).sorted().toList();
  }

  private Hold hold(String robot) {
    return robots.getOrDefault(robot, new Hold(false, false));
  }

  boolean isInFront(String view) {
    return views.views().contains(view) && views.fronted(view).equals(views);
  }

  Optional<String> addedType(String view) {
    return views.added().stream().filter(a -> a.id().equals(view)).map(Arrangement.Added::type).findFirst();
  }
}
