package org.robotui.testkit.rfic;

import static org.robotui.testkit.rfic.Trial.require;

import java.util.List;
import org.robotui.api.link.LinkState;

/** Robots that go, come back, hang, or say what nobody can read. */
final class FaultClauses {
  private static final int COMMANDS = 200;

  private FaultClauses() {}

  static List<Clause> all() {
    return List.of(
        Clause.connected("tells why a robot is lost, and brings its data again when it is back", FaultClauses::back,
            Capability.RETURN),
        Clause.connected("tells of a robot that hangs, and goes on with it", FaultClauses::hung, Capability.HANG),
        Clause.connected("tells of a robot that hangs though it is commanded", FaultClauses::hungDriven,
            Capability.HANG, Capability.COMMANDS),
        Clause.connected("complains of what nobody can read, and goes on", FaultClauses::garbled, Capability.GARBAGE),
        Clause.connected("ends in time while the robot hangs", FaultClauses::endsHung, Capability.HANG),
        Clause.connected("ends in time while the robot hangs and is commanded", FaultClauses::endsCommanding,
            Capability.HANG, Capability.COMMANDS));
  }

  private static void back(Trial trial) throws Exception {
    Sample sample = trial.first();
    trial.want(sample, true);
    trial.next(sample);
    for (int i = 0; i < 2; i++) {
      trial.peer.kill();
      trial.await("the loss is told", () -> !(trial.link() instanceof LinkState.Connected),
          () -> trial.link().toString());
      trial.await("the loss has a reason", () -> !trial.link().reason().isBlank(), () -> trial.link().toString());
      trial.peer.start();
      trial.awaitConnected();
      trial.next(sample);
    }
  }

  private static void hung(Trial trial) throws Exception {
    Sample sample = trial.first();
    trial.want(sample, true);
    trial.next(sample);
    trial.peer.hang();
    trial.await("it is told that the robot hangs",
        () -> !(trial.link() instanceof LinkState.Connected) && !trial.link().reason().isBlank(),
        () -> trial.link().toString());
    trial.peer.goOn();
    trial.awaitConnected();
    trial.next(sample);
  }

  /** What is sent is no sign of life, also where it is heard by whoever sends it. */
  private static void hungDriven(Trial trial) throws Exception {
    trial.want(trial.first(), true);
    trial.next(trial.first());
    trial.drive();
    trial.peer.hang();
    trial.await("it is told that the robot hangs", () -> {
      if (trial.context.commands.containsKey(trial.peer.motionPort())) {
        trial.send(trial.peer.motion());
      }
      return !(trial.link() instanceof LinkState.Connected) && !trial.link().reason().isBlank();
    }, () -> trial.link().toString());
  }

  private static void garbled(Trial trial) throws Exception {
    for (Sample each : trial.peer.samples()) {
      trial.want(each, true);
      trial.next(each);
    }
    long links = trial.context.links.size();
    trial.peer.garble();
    trial.awaitSaying("it complains", () -> !trial.complaints().isEmpty() || lostSince(trial, links),
        () -> trial.link() + ", no complaint");
    trial.awaitConnected();
    for (Sample each : trial.peer.samples()) {
      trial.next(each);
    }
  }

  private static boolean lostSince(Trial trial, long links) {
    return trial.context.links.stream().skip(links)
        .anyMatch(l -> !(l instanceof LinkState.Connected) && !l.reason().isBlank());
  }

  private static void endsHung(Trial trial) throws Exception {
    Sample sample = trial.first();
    trial.want(sample, true);
    trial.next(sample);
    trial.peer.hang();
    trial.end();
    require(trial.link() instanceof LinkState.Disconnected, "after its end it is " + trial.link());
  }

  private static void endsCommanding(Trial trial) throws Exception {
    trial.drive();
    trial.peer.hang();
    for (int i = 0; i < COMMANDS; i++) {
      trial.send(trial.peer.motion());
    }
    trial.end();
  }
}
