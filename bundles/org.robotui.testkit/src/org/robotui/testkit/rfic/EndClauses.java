package org.robotui.testkit.rfic;

import static org.robotui.testkit.rfic.Trial.require;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.function.Supplier;
import org.robotui.api.link.LinkState;

/** What is left when it has ended, at whatever moment. */
final class EndClauses {
  private static final int MOMENTS = 6;
  private static final int LATEST_MILLIS = 600;

  private EndClauses() {}

  static List<Clause> all() {
    return List.of(
        Clause.fresh("ends before it began", Trial::end),
        Clause.fresh("ends while it calls a robot that is away", EndClauses::calling),
        Clause.fresh("ends while it calls a robot that hangs", EndClauses::callingMute, Capability.HANG),
        Clause.connected("ends twice", EndClauses::twice),
        new Clause("ends at any moment", List.of(), EndClauses::anyMoment),
        Clause.connected("withdraws at its end all that it offered, and brings nothing more", EndClauses::withdrawn),
        Clause.connected("unlinks itself from the robot", EndClauses::unlinked, Capability.LINKS),
        Clause.fresh("leaves the robot as it was", EndClauses::asItWas, Capability.REGISTRATIONS),
        new Clause("leaves no thread and no socket", List.of(), EndClauses::nothingLeft));
  }

  private static void calling(Trial trial) throws Exception {
    trial.begin();
    Trial.pass(Trial.MOMENT);
    trial.end();
    require(trial.link() instanceof LinkState.Disconnected, "after its end it is " + trial.link());
  }

  private static void callingMute(Trial trial) throws Exception {
    trial.peer.start();
    trial.peer.hang();
    calling(trial);
  }

  private static void twice(Trial trial) throws Exception {
    trial.end();
    trial.end();
  }

  private static void anyMoment(Supplier<? extends Peer> peers) throws Exception {
    Random random = new Random(7);
    for (int i = 0; i < MOMENTS; i++) {
      try (Trial trial = new Trial(peers)) {
        trial.peer.start();
        trial.begin();
        trial.saying(Duration.ofMillis(random.nextInt(LATEST_MILLIS)));
        trial.end();
      }
    }
  }

  private static void withdrawn(Trial trial) throws Exception {
    Sample sample = trial.first();
    trial.want(sample, true);
    trial.next(sample);
    trial.end();
    Map<String, Set<String>> left =
        Map.of("streams", trial.context.streams.keySet(), "commands", trial.context.commands.keySet(),
            "calls", trial.context.handlers.keySet(), "browsers", trial.context.browsers.keySet());
    left.forEach((what, names) -> require(names.isEmpty(), what + " are left: " + names));
    int before = trial.brought(sample);
    trial.saying(Trial.MOMENT);
    require(trial.brought(sample) == before, sample + " brings something after the end");
  }

  private static void unlinked(Trial trial) throws Exception {
    Sample sample = trial.first();
    trial.want(sample, true);
    trial.next(sample);
    require(trial.peer.links() > 0, "the robot of the test sees no link");
    trial.end();
    trial.await("the robot sees no link", () -> trial.peer.links() == 0, () -> trial.peer.links() + " links");
  }

  private static void asItWas(Trial trial) throws Exception {
    trial.peer.start();
    Sample sample = trial.first();
    Set<String> before = trial.peer.registrations();
    trial.begin();
    trial.awaitConnected();
    trial.want(sample, true);
    trial.next(sample);
    if (!trial.peer.lacks().containsKey(Capability.COMMANDS)) {
      trial.drive();
    }
    require(!trial.peer.registrations().equals(before), "the robot of the test does not see that somebody was there");
    trial.end();
    trial.await("the robot is as it was", () -> trial.peer.registrations().equals(before),
        () -> trial.peer.registrations() + " instead of " + before);
  }

  private static void nothingLeft(Supplier<? extends Peer> peers) throws Exception {
    // what Java opens once for all is open after a first round
    round(peers, false);
    round(peers, true);
  }

  private static void round(Supplier<? extends Peer> peers, boolean strictly) throws IOException, InterruptedException {
    try (Trial trial = new Trial(peers)) {
      trial.peer.start();
      Resources before = Resources.now();
      trial.begin();
      trial.awaitConnected();
      trial.want(trial.first(), true);
      trial.next(trial.first());
      if (!trial.peer.lacks().containsKey(Capability.COMMANDS)) {
        trial.drive();
      }
      trial.end();
      if (strictly) {
        trial.await("nothing is left", () -> Resources.now().beyond(before).isEmpty(), () -> left(before));
      }
    }
  }

  private static String left(Resources before) {
    try {
      return Resources.now().beyond(before).toString();
    } catch (IOException e) {
      return e.toString();
    }
  }
}
