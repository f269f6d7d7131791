package org.robotui.testkit.rfic;

import static org.robotui.testkit.rfic.Trial.require;

import java.util.List;
import java.util.Optional;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.CommandSink.Sent;

/** What goes to the robot. */
final class CommandClauses {
  private CommandClauses() {}

  static List<Clause> all() {
    return List.of(
        Clause.connected("takes motions, and the robot hears them with their units", CommandClauses::motion,
            Capability.COMMANDS),
        Clause.connected("stops what it drives when it ends", CommandClauses::stopped, Capability.COMMANDS),
        Clause.connected("brings a stop to the robot that is given right before its end", CommandClauses::lastStop,
            Capability.COMMANDS),
        Clause.connected("tells the robot nothing that nobody commanded", CommandClauses::nothing, Capability.COMMANDS),
        Clause.connected("leaves alone at its end what it drives no more", CommandClauses::othersDrive,
            Capability.COMMANDS),
        Clause.connected("sends nothing after its end", CommandClauses::afterEnd, Capability.COMMANDS),
        Clause.connected("keeps no command for a robot that comes back", CommandClauses::nothingKept,
            Capability.COMMANDS, Capability.RETURN));
  }

  private static void motion(Trial trial) throws Exception {
    trial.drive();
    require(trial.context.commands.get(trial.peer.motionPort()).isMotion(),
        trial.peer.motionPort() + " is no port for motions, so that no stop would reach it");
    Optional<String> difference = Alike.difference(trial.peer.motion(), trial.peer.heard().getFirst());
    require(difference.isEmpty(), difference.orElse(""));
  }

  private static void stopped(Trial trial) throws Exception {
    trial.drive();
    trial.end();
    trial.awaitStopped();
  }

  /** As core does where it ends a robot interface that drives. */
  private static void lastStop(Trial trial) throws Exception {
    trial.drive();
    Sent sent = trial.send(trial.peer.motion().stopped());
    trial.end();
    require(sent instanceof Sent.Out, "a stop is refused: " + sent);
    trial.awaitStopped();
  }

  private static void nothing(Trial trial) throws Exception {
    for (Sample sample : trial.peer.samples()) {
      trial.want(sample, true);
      trial.next(sample);
    }
    trial.end();
    Trial.pass(Trial.MOMENT);
    require(trial.peer.heard().isEmpty(), "the robot heard " + trial.peer.heard());
  }

  private static void othersDrive(Trial trial) throws Exception {
    trial.drive();
    require(trial.send(trial.peer.motion().stopped()) instanceof Sent.Out, "a stop is refused");
    trial.awaitStopped();
    int before = trial.peer.heard().size();
    trial.end();
    Trial.pass(Trial.MOMENT);
    require(trial.peer.heard().size() == before, "the robot heard what stops others: " + trial.peer.heard());
  }

  private static void afterEnd(Trial trial) throws Exception {
    trial.drive();
    trial.end();
    trial.awaitStopped();
    int before = trial.peer.heard().size();
    require(refuses(trial), "a motion is taken after the end");
    Trial.pass(Trial.MOMENT);
    require(trial.peer.heard().size() == before, "the robot heard " + trial.peer.heard().getLast() + " after the end");
  }

  private static boolean refuses(Trial trial) {
    try {
      return trial.send(trial.peer.motion()) instanceof Sent.Refused;
    } catch (IllegalStateException e) {
      return true;
    }
  }

  private static void nothingKept(Trial trial) throws Exception {
    trial.drive();
    trial.peer.kill();
    trial.await("the loss is told", () -> !(trial.link() instanceof LinkState.Connected),
        () -> trial.link().toString());
    int before = trial.peer.heard().size();
    trial.send(trial.peer.motion());
    trial.peer.start();
    trial.awaitConnected();
    trial.saying(Trial.MOMENT);
    long late = trial.peer.heard().stream().skip(before).filter(m -> Alike.difference(trial.peer.motion(), m).isEmpty())
        .count();
    require(late == 0, "the robot heard what was commanded while it was away");
  }
}
