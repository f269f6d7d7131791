package org.robotui.core.internal.command;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.core.internal.support.Await;

class StopWarmUpTest {
  @Test
  void itsRobotIsStoppedAndNoThreadOfItIsLeft() {
    assertTrue(StopWarmUp.run());
    Await.until("its threads have ended",
        () -> Thread.getAllStackTraces().keySet().stream().noneMatch(t -> t.getName().equals("arbiter-warm-up")));
  }
}
