package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;

class CoreTimerTest {
  @Test
  void whatIsPlannedAfterTheEndIsForgotten() throws InterruptedException {
    AtomicBoolean ran = new AtomicBoolean();
    ScheduledThreadPoolExecutor timer = Core.timer();
    timer.shutdownNow();
    timer.schedule(() -> ran.set(true), 0, TimeUnit.MILLISECONDS);
    assertTrue(timer.awaitTermination(10, TimeUnit.SECONDS));
    assertFalse(ran.get());
  }
}
