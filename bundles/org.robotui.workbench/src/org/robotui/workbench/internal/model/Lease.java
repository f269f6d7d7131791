package org.robotui.workbench.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.link.LinkState;
import org.robotui.ui.Health;

/**
 * Who drives the robot that a window shows, and whether it is stopped.
 *
 * @param health the dot
 * @param words for example {@code You drive Keira}
 */
public record Lease(Health health, String words) {
  /**
   * Reads the authorities of a robot, or of none. Who holds the lease of a robot that is not reached drives nothing.
   */
  public static Lease of(List<Authority> authorities, LinkState link, Principal user) {
    Optional<Authority> stopped = authorities.stream().filter(a -> a.stoppedBy().isPresent()).findFirst();
    if (stopped.isPresent()) {
      return new Lease(Health.BAD, "Stopped by " + stopped.get().stoppedBy().map(Principal::label).orElse("somebody"));
    }
    return authorities.isEmpty() ? new Lease(Health.NONE, "Nothing to drive") : of(authorities.getFirst(), link, user);
  }

  private static Lease of(Authority authority, LinkState link, Principal user) {
    return authority.holder().map(holder -> holder.equals(user)
        ? yours(authority.robot(), link)
        : new Lease(Health.WARNING, holder.label() + " controls " + authority.robot()))
        .orElse(new Lease(Health.WAITING, "Nobody controls " + authority.robot()));
  }

  private static Lease yours(String robot, LinkState link) {
    return switch (link) {
      case LinkState.Connected c -> new Lease(Health.OK, "You control " + robot);
      case LinkState.Degraded d -> new Lease(Health.WARNING, "You control " + robot);
      default -> new Lease(Health.WARNING, "No link to " + robot);
    };
  }
}
