package org.robotui.sim.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
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
        10,
        unexpected -> {});
    runner.start();
    assertTrue(enough.await(10, TimeUnit.SECONDS));
    runner.close();
    int count = dues.size();
    long onGrid = IntStream.range(1, 20).filter(i -> dues.get(i) - dues.get(i - 1) == 1_000_000).count();
    assertTrue(onGrid > 10, "on the grid: " + onGrid);
    assertTrue(Thread.getAllStackTraces().keySet().stream().noneMatch(t -> t.getName().equals("simulation")));
    assertEquals(count, dues.size());
  }

  @Test
  void aStepThatThrowsIsReportedAndTheLast() throws InterruptedException {
    BlockingQueue<RuntimeException> failures = new LinkedBlockingQueue<>();
    IllegalStateException cause = new IllegalStateException("broken");
    Runner runner = new Runner(
        due -> {
          throw cause;
        },
        10,
        failures::add);
    runner.start();
    assertSame(cause, failures.poll(10, TimeUnit.SECONDS));
    runner.close();
    assertTrue(failures.isEmpty());
  }
}
