package org.robotui.workbench.internal.rcp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ch.qos.logback.classic.LoggerContext;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.eclipse.core.runtime.IStatus;
import org.junit.jupiter.api.Test;
import org.slf4j.Logger;
import org.slf4j.helpers.NOPLoggerFactory;
import org.slf4j.helpers.NOPMDCAdapter;

class ErrorLogTest {
  private final LoggerContext context = new LoggerContext();
  private final Logger logger = context.getLogger("org.robotui.ros.internal.node.Registrar");
  private final List<IStatus> told = new CopyOnWriteArrayList<>();

  ErrorLogTest() {
    context.setMDCAdapter(new NOPMDCAdapter());
  }

  @Test
  void warningsAndErrorsReachThePlatformWithTheirBundleAndTheirCause() {
    Exception cause = new IllegalStateException("gone");
    try (ErrorLog log = ErrorLog.open(context, told::add).orElseThrow()) {
      assertTrue(log.isStarted());
      logger.info("nothing to see");
      logger.warn("{} of {}", 1, 2);
      logger.error("it failed", cause);
    }
    assertEquals(List.of(IStatus.WARNING, IStatus.ERROR), told.stream().map(IStatus::getSeverity).toList());
    assertEquals(List.of("1 of 2", "it failed"), told.stream().map(IStatus::getMessage).toList());
    assertEquals("org.robotui.ros", told.getFirst().getPlugin());
    assertSame(cause, told.getLast().getException());
  }

  @Test
  void whatIsLoggedWhileThePlatformTakesOneIsNotHandedOnAgain() {
    try (ErrorLog log = ErrorLog.open(context, this::takeAndComplain).orElseThrow()) {
      assertTrue(log.isStarted());
      logger.warn("once");
      logger.warn("twice");
    }
    assertEquals(List.of("once", "twice"), told.stream().map(IStatus::getMessage).toList());
  }

  @Test
  void whoLogsDoesNotWaitForAPlatformThatHangs() {
    CountDownLatch hangs = new CountDownLatch(1);
    try (ErrorLog log = ErrorLog.open(context, status -> take(hangs, status)).orElseThrow()) {
      assertTrue(log.isStarted());
      logger.warn("once");
      logger.warn("twice");
      hangs.countDown();
    }
    assertEquals(2, told.size());
  }

  private void take(CountDownLatch hangs, IStatus status) {
    try {
      hangs.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    told.add(status);
  }

  private void takeAndComplain(IStatus status) {
    told.add(status);
    logger.error("the log itself has failed");
  }

  @Test
  void nothingIsHandedOnAfterTheEndNorWithoutLogback() {
    ErrorLog.open(context, told::add).orElseThrow().close();
    logger.warn("late");
    assertEquals(List.of(), told);
    assertTrue(ErrorLog.open(new NOPLoggerFactory(), told::add).isEmpty());
  }
}
