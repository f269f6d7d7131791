package org.robotui.workbench.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.link.LinkState;
import org.robotui.ui.Health;

/**
 * Who controls the robot that a window shows, or the robots, and whether one is stopped.
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
    return switch (authorities.size()) {
      case 0 -> new Lease(Health.NONE, "Nothing to drive");
      case 1 -> of(authorities.getFirst(), link, user);
      default -> ofSeveral(authorities, user);
    };
  }

  private static Lease of(Authority authority, LinkState link, Principal user) {
    return authority.holder().map(holder -> holder.equals(user)
        ? yours(authority.robot(), link)
        : new Lease(Health.WARNING, holder.label() + " controls " + authority.robot()))
        .orElse(new Lease(Health.WAITING, "Nobody controls " + authority.robot()));
  }

  private static Lease ofSeveral(List<Authority> all, Principal user) {
    List<Authority> yours = all.stream().filter(a -> a.holder().filter(user::equals).isPresent()).toList();
    if (!yours.isEmpty()) {
      return new Lease(Health.OK, "You control " + robots(yours, all.size()));
    }
    List<Authority> held = all.stream().filter(a -> a.holder().isPresent()).toList();
    if (held.isEmpty()) {
      return new Lease(Health.WAITING, "Nobody controls a robot");
    }
    List<String> holders = held.stream().map(a -> a.holder().orElseThrow().label()).distinct().toList();
    return new Lease(Health.WARNING,
        (holders.size() == 1 ? holders.getFirst() + " controls " : "Others control ") + robots(held, all.size()));
  }

  private static String robots(List<Authority> held, int all) {
    if (held.size() == 1) {
      return held.getFirst().robot();
    }
    return held.size() == all ? "all " + all + " robots" : held.size() + " of " + all + " robots";
  }

  private static Lease yours(String robot, LinkState link) {
    return switch (link) {
      case LinkState.Connected c -> new Lease(Health.OK, "You control " + robot);
      case LinkState.Degraded d -> new Lease(Health.WARNING, "You control " + robot);
      default -> new Lease(Health.WARNING, "No link to " + robot);
    };
  }
}
