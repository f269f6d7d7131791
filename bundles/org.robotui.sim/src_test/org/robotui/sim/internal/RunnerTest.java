package org.robotui.sim.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class RunnerTest {
  @Test
  void stepsAreDueOnAGridAndEndWithClose() throws InterruptedException {
    List<Long> dues = new CopyOnWriteArrayList<>();
    CountDownLatch enough = new CountDownLatch(20);
    Runner runner = new Runner(
        due -> {
          dues.add(due);
          enough.countDown();
        },
        10);
    runner.start();
    assertTrue(enough.await(10, TimeUnit.SECONDS));
    runner.close();
    int count = dues.size();
    assertEquals(1_000_000, dues.get(1) - dues.get(0));
    assertTrue(Thread.getAllStackTraces().keySet().stream().noneMatch(t -> t.getName().equals("simulation")));
    assertEquals(count, dues.size());
  }
}
