package org.robotui.rfic.ros.internal.graph;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.net.call.Outcome;

class LinkVerdictTest {
  private static final Duration LOOK = Duration.ofSeconds(1);
  private static final Outcome<String> LATE = new Outcome.TimedOut<>("no answer", Duration.ofSeconds(3));
  private static final Outcome<String> REFUSED = new Outcome.Failed<>("connection refused");
  private static final LinkState CONNECTED = new LinkState.Connected("master");

  private final LinkVerdict verdict = new LinkVerdict("master", LOOK);

  private static Optional<LinkState> degraded(String reason) {
    return Optional.of(new LinkState.Degraded("master", reason + "; established links go on"));
  }

  @Test
  void oneLateAnswerIsNoNewsWhileTopicsFlowButASecondOneIs() {
    assertEquals(CONNECTED, verdict.answered(""));
    assertEquals(Optional.empty(), verdict.unanswered(LATE, true));
    assertEquals(degraded("no answer"), verdict.unanswered(LATE, true));
    assertEquals(degraded("no answer"), verdict.unanswered(LATE, true));
    assertEquals(CONNECTED, verdict.answered(""));
    assertEquals(Optional.empty(), verdict.unanswered(LATE, true));
  }

  @Test
  void aMasterThatHasGoneIsSaidAtOnce() {
    verdict.answered("");
    assertEquals(degraded("connection refused"), verdict.unanswered(REFUSED, true));
  }

  @Test
  void withoutTopicsThatFlowTheLinkHasFailed() {
    Optional<LinkState> failed = Optional.of(new LinkState.Failed("no answer", LOOK));
    assertEquals(failed, verdict.unanswered(LATE, true), "it never answered");
    verdict.answered("");
    assertEquals(failed, verdict.unanswered(LATE, false));
  }

  @Test
  void aProblemOfATopicIsSaidWithTheAnswer() {
    assertEquals(new LinkState.Degraded("master", "nobody publishes /scan any more"),
        verdict.answered("nobody publishes /scan any more"));
  }
}
