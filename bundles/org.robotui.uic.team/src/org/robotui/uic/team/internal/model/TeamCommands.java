package org.robotui.uic.team.internal.model;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.UicContext;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Authority.LeaseOutcome;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.command.Output;
import org.robotui.api.command.Principal;
import org.robotui.api.host.RuicView;
import org.robotui.api.port.SourceId;
import org.robotui.data.command.VelocityCommand;
import org.robotui.ui.Health;
import org.robotui.ui.scene.CommandNotice;
import org.robotui.uic.team.internal.TeamPorts;

/** What can be done with robots. All of it passes the arbiter of each robot. Any thread; never blocks. */
public final class TeamCommands {
  private static final Duration VALID = Duration.ofSeconds(2);

  private final UicContext context;
  private final RuicView ruic;
  private final Principal user;
  private final Output<VelocityCommand> velocity;

  /** Commands through the ports of a view. */
  public TeamCommands(UicContext context) {
    this.context = context;
    this.ruic = context.ruic();
    this.user = context.principal();
    this.velocity = context.output(TeamPorts.VELOCITY);
  }

  /** Stops them, latched. Asks nobody. */
  public CommandNotice stop(Collection<String> robots) {
    authorities(robots).forEach(a -> a.stop(user));
    return new CommandNotice(Health.OK, "Stopped " + who(robots));
  }

  /** Lets them move again; nothing moves by that. */
  public CommandNotice release(Collection<String> robots) {
    List<Authority> stopped = authorities(robots).stream().filter(a -> a.stoppedBy().isPresent()).toList();
    stopped.forEach(a -> a.releaseStop(user));
    return stopped.isEmpty() ? new CommandNotice(Health.OK, "None of them was stopped")
        : new CommandNotice(Health.OK, "Released " + who(stopped.stream().map(Authority::robot).toList()));
  }

  /** Has them keep still, which ends what they are going to. Takes the lease where nobody has it. */
  public CommandNotice zero(Collection<String> robots) {
    List<String> sent = new ArrayList<>();
    List<String> not = new ArrayList<>();
    for (Authority robot : authorities(robots)) {
      zero(robot).ifPresentOrElse(why -> not.add(robot.robot() + ": " + why), () -> sent.add(robot.robot()));
    }
    if (not.isEmpty()) {
      return new CommandNotice(Health.OK, "Velocity zero sent to " + who(sent));
    }
    String all = String.join("; ", not);
    return new CommandNotice(Health.BAD,
        sent.isEmpty() ? "Not sent: " + all : "Velocity zero sent to " + who(sent) + ", but not to " + all);
  }

  private Optional<String> zero(Authority robot) {
    List<SourceId> targets = velocity.targets().stream()
        .filter(t -> ruic.authority(t.component()).filter(a -> a.robot().equals(robot.robot())).isPresent()).toList();
    if (targets.isEmpty()) {
      return Optional.of("it takes no velocities");
    }
    if (robot.take(user, false) instanceof LeaseOutcome.HeldBy held) {
      return Optional.of(held.holder().label() + " controls it");
    }
    return targets.stream().map(t -> velocity.send(t, VelocityCommand.ZERO, VALID))
        .flatMap(o -> o instanceof CommandOutcome.Refused r ? Optional.of(r.explanation()).stream()
            : Optional.<String>empty().stream())
        .findFirst();
  }

  /** Shows the interface that is this robot's own. */
  public CommandNotice open(String robot) {
    Optional<RuicView> own = own(robot);
    own.ifPresent(r -> context.show(r.name()));
    return own.map(r -> new CommandNotice(Health.OK, "")).orElseGet(
        () -> new CommandNotice(Health.WARNING, robot + " has no UI of its own. Write one in the configuration:  "
            + robot + ": {type: mobilebase, start: when_shown, rfics: ...}, or one template with 'for:' for all"));
  }

  /** By its name, else the only other one that has this robot and no other. */
  private Optional<RuicView> own(String robot) {
    List<RuicView> others = context.ruics().stream().filter(r -> !r.name().equals(ruic.name())).toList();
    return others.stream().filter(r -> r.name().equals(robot)).findFirst()
        .or(() -> others.stream()
            .filter(r -> r.authorities().stream().map(Authority::robot).toList().equals(List.of(robot))).findFirst());
  }

  /** Which robots the user means, for all views. */
  public void select(Set<String> robots) {
    if (!ruic.selection().robots().equals(robots)) {
      ruic.selection().set(robots);
    }
  }

  private List<Authority> authorities(Collection<String> robots) {
    return ruic.authorities().stream().filter(a -> robots.contains(a.robot())).toList();
  }

  private static String who(Collection<String> robots) {
    return robots.size() <= 4 ? String.join(", ", robots) : robots.size() + " robots";
  }
}
