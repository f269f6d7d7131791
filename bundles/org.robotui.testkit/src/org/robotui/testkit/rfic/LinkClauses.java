package org.robotui.testkit.rfic;

import static org.robotui.testkit.rfic.Trial.require;

import java.time.Duration;
import java.util.List;
import org.robotui.api.link.LinkState;

/** What is said of the link. */
final class LinkClauses {
  /** A link that is claimed though nothing answers is claimed with the first attempt. */
  private static final Duration A_WHILE = Duration.ofSeconds(1);

  private LinkClauses() {}

  static List<Clause> all() {
    return List.of(
        Clause.fresh("says nothing and asks nobody before it begins", LinkClauses::silent),
        Clause.fresh("is connecting first, and connected only when the robot is there", LinkClauses::order),
        Clause.fresh("says why a robot that is away is not reached, and when it tries again", LinkClauses::away,
            Capability.LINKS),
        Clause.fresh("is not connected to a robot that hangs from the beginning", LinkClauses::mute, Capability.HANG),
        Clause.connected("is disconnected after its end", LinkClauses::disconnected));
  }

  private static void silent(Trial trial) throws Exception {
    trial.peer.start();
    trial.saying(Trial.MOMENT);
    require(trial.context.links.isEmpty(), "it reports " + trial.context.links + " before it begins");
    require(trial.context.threads.stream().noneMatch(Thread::isAlive), "a thread runs before it begins");
    require(trial.peer.links() == 0, "it links itself before it begins");
  }

  private static void order(Trial trial) throws Exception {
    trial.begin();
    trial.await("it reports something", () -> !trial.context.links.isEmpty(), () -> "nothing");
    require(trial.context.links.getFirst() instanceof LinkState.Connecting,
        "the first state is " + trial.context.links.getFirst());
    Trial.pass(A_WHILE);
    require(!trial.everConnected(), "it is connected to a robot that is away: " + trial.context.links);
    trial.peer.start();
    trial.awaitConnected();
    require(!((LinkState.Connected) trial.link()).peer().isBlank(), "it does not say to whom it is connected");
  }

  private static void away(Trial trial) throws Exception {
    trial.begin();
    trial.await("it fails", () -> trial.link() instanceof LinkState.Failed, () -> trial.link().toString());
    LinkState.Failed failed = (LinkState.Failed) trial.context.links.stream().filter(LinkState.Failed.class::isInstance)
        .findFirst().orElseThrow();
    require(!failed.reason().isBlank() && !failed.reason().equals("null"), "there is no reason for " + failed);
    require(!failed.retryIn().isNegative(), "it tries again before now: " + failed);
  }

  private static void mute(Trial trial) throws Exception {
    trial.peer.start();
    trial.peer.hang();
    trial.begin();
    Trial.pass(A_WHILE);
    require(!trial.everConnected(), "it is connected to a robot that says nothing: " + trial.context.links);
    trial.peer.goOn();
    trial.awaitConnected();
  }

  private static void disconnected(Trial trial) throws Exception {
    trial.end();
    require(trial.link() instanceof LinkState.Disconnected, "after its end it is " + trial.link());
    int reported = trial.context.links.size();
    trial.saying(Trial.MOMENT);
    require(trial.context.links.size() == reported, "it reports after its end: " + trial.link());
  }
}
