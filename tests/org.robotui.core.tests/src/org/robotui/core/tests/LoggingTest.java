package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.osgi.framework.FrameworkUtil;
import org.slf4j.LoggerFactory;

/** SLF4J finds its provider without anything that weaves classes. */
class LoggingTest {
  @Test
  void logsGoToLogback() {
    Class<?> factory = LoggerFactory.getILoggerFactory().getClass();

    assertEquals("ch.qos.logback.classic", FrameworkUtil.getBundle(factory).getSymbolicName());
  }
}
