package org.robotui.workbench.internal.rcp;

import ch.qos.logback.classic.AsyncAppender;
import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.classic.spi.ThrowableProxy;
import ch.qos.logback.core.UnsynchronizedAppenderBase;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Status;
import org.slf4j.ILoggerFactory;

/**
 * Hands warnings and errors of all that log through SLF4J to the platform's log, which the Error Log view shows, on a
 * thread of its own: the platform may wait for the display, and who logs, such as the watch over the display, must not.
 * What the platform itself logs while it takes one goes to the file alone. Safe for all threads.
 */
public final class ErrorLog extends UnsynchronizedAppenderBase<ILoggingEvent> implements AutoCloseable {
  private static final String INTERNAL = ".internal.";
  private static final String NAME = "platform";
  private static final String WORKER = "AsyncAppender-Worker-" + NAME; // as Logback names it

  private final Logger root;
  private final AsyncAppender queue = new AsyncAppender();
  private final Consumer<IStatus> platform;

  private ErrorLog(LoggerContext context, Consumer<IStatus> platform) {
    this.root = context.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    this.platform = platform;
    setContext(context);
    queue.setContext(context);
    queue.setName(NAME);
    queue.setNeverBlock(true);
    queue.addAppender(this);
  }

  /** Begins to hand on; none where another than Logback takes the log. */
  public static Optional<ErrorLog> open(ILoggerFactory factory, Consumer<IStatus> platform) {
    if (!(factory instanceof LoggerContext context)) {
      return Optional.empty();
    }
    ErrorLog log = new ErrorLog(context, platform);
    log.start();
    log.queue.start();
    log.root.addAppender(log.queue);
    return Optional.of(log);
  }

  @Override
  protected void append(ILoggingEvent event) {
    if (event.getLevel().isGreaterOrEqual(Level.WARN) && !WORKER.equals(event.getThreadName())) {
      int severity = event.getLevel() == Level.WARN ? IStatus.WARNING : IStatus.ERROR;
      platform.accept(new Status(severity, origin(event.getLoggerName()), event.getFormattedMessage(), thrown(event)));
    }
  }

  /** Null where there is nothing, as the platform has it. */
  private static Throwable thrown(ILoggingEvent event) {
    return event.getThrowableProxy() instanceof ThrowableProxy proxy ? proxy.getThrowable() : null;
  }

  /** The bundle, which our packages are named after; elsewhere the package. */
  private static String origin(String logger) {
    int internal = logger.indexOf(INTERNAL);
    int end = internal >= 0 ? internal : logger.lastIndexOf('.');
    return end > 0 ? logger.substring(0, end) : logger;
  }

  @Override
  public void close() {
    root.detachAppender(queue);
    queue.stop(); // hands on what waits, for a second at most
    stop();
  }
}
