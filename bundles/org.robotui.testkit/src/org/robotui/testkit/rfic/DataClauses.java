package org.robotui.testkit.rfic;

import static org.robotui.testkit.rfic.Trial.require;

import java.util.List;
import java.util.Optional;
import org.robotui.testkit.FakeRficContext.Published;

/** What comes from the robot. */
final class DataClauses {
  private DataClauses() {}

  static List<Clause> all() {
    return List.of(
        Clause.connected("brings what the robot says, in SI units and in frames of this robot", DataClauses::values),
        Clause.connected("tells when something was measured, by the clock of its source", DataClauses::stamps,
            Capability.STAMPS),
        Clause.connected("tells when something was received, by the clock of this machine", DataClauses::receipts),
        Clause.connected("brings nothing that nobody wants", DataClauses::unwanted),
        Clause.connected("asks the robot for nothing that nobody wants", DataClauses::demand, Capability.DEMAND),
        Clause.connected("brings again what was unwanted for a while", DataClauses::again));
  }

  private static void values(Trial trial) throws Exception {
    for (Sample sample : trial.peer.samples()) {
      trial.want(sample, true);
      require(trial.context.streams.get(sample.port()).type().isInstance(sample.expected()),
          sample + " offers " + trial.context.streams.get(sample.port()).typeName());
      Optional<String> difference = Alike.difference(sample.expected(), trial.next(sample).value());
      require(difference.isEmpty(), sample + ": " + difference.orElse(""));
    }
  }

  private static void stamps(Trial trial) throws Exception {
    for (Sample sample : trial.peer.samples()) {
      trial.want(sample, true);
      Published came = trial.next(sample);
      require(came.stamp().equals(sample.stamp()),
          sample + " has the stamp " + came.stamp() + " instead of " + sample.stamp());
    }
  }

  private static void receipts(Trial trial) throws Exception {
    Sample sample = trial.first();
    long last = trial.made;
    trial.want(sample, true);
    for (int i = 0; i < 5; i++) {
      trial.next(sample);
    }
    for (Published came : trial.context.published.get(sample.port())) {
      require(came.receivedNanos() - last >= 0, "receive times go back by " + (last - came.receivedNanos()) + " ns");
      last = came.receivedNanos();
    }
    require(System.nanoTime() - last >= 0, "something was received in the future");
  }

  private static void unwanted(Trial trial) throws Exception {
    Sample sample = trial.first();
    trial.want(sample, false);
    trial.saying(Trial.MOMENT);
    require(trial.brought(sample) == 0, sample + " brings what nobody wants");
  }

  private static void demand(Trial trial) throws Exception {
    Sample sample = trial.first();
    trial.awaitSaying(sample + " is offered", () -> trial.context.streams.containsKey(sample.port()),
        () -> trial.context.streams.keySet().toString());
    trial.saying(Trial.MOMENT);
    for (Sample each : trial.peer.samples()) {
      require(trial.peer.listeners(each) == 0, "the robot is asked for " + each + ", which nobody wants");
    }
    trial.want(sample, true);
    trial.awaitSaying("the robot is asked for " + sample, () -> trial.peer.listeners(sample) > 0,
        () -> trial.link().toString());
    trial.want(sample, false);
    trial.awaitSaying("the robot is asked for " + sample + " no more", () -> trial.peer.listeners(sample) == 0,
        () -> trial.link().toString());
  }

  private static void again(Trial trial) throws Exception {
    Sample sample = trial.first();
    trial.want(sample, true);
    trial.next(sample);
    trial.want(sample, false);
    trial.saying(Trial.MOMENT);
    trial.want(sample, true);
    trial.next(sample);
  }
}
