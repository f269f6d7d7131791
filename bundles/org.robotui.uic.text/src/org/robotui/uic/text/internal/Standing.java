package org.robotui.uic.text.internal;

import java.util.List;
import java.util.stream.Collectors;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;

/**
 * Who drives a robot and whether it is stopped, in words.
 *
 * @param text for example {@code You drive}
 */
record Standing(String text) {
  static Standing of(List<Authority> authorities) {
    boolean several = authorities.size() > 1;
    return new Standing(authorities.stream()
        .map(authority -> (several ? authority.robot() + ": " : "") + words(authority))
        .collect(Collectors.joining(", ")));
  }

  private static String words(Authority authority) {
    return authority.stoppedBy().map(by -> "STOPPED by " + by.label())
        .or(() -> authority.holder().map(Standing::drives))
        .orElse("nobody has control");
  }

  private static String drives(Principal holder) {
    return holder.label() + (holder.label().equals("You") ? " drive" : " has control");
  }
}
