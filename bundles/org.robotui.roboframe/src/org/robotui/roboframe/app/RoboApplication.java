package org.robotui.roboframe.app;

import java.io.Closeable;
import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.robotui.message.roboframe.LogLineStreamable;
import org.robotui.message.roboframe.ModuleStateStreamable;
import org.robotui.message.roboframe.ModuleStatesStreamable;
import org.robotui.net.thread.Workers;
import org.robotui.roboframe.board.Blackboard;
import org.robotui.roboframe.board.ChannelKey;
import org.robotui.roboframe.board.Connector;
import org.robotui.roboframe.board.KeyOutput;
import org.robotui.roboframe.board.Router;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Modules, the blackboard between them, and the router to other applications. How the modules are doing stands at
 * {@link #MODULES}, once a second and when one fails; errors are also lines of {@link #LOG_LINES}. Safe for all
 * threads.
 */
public final class RoboApplication implements Closeable {

  /** How all modules are doing. */
  public static final ChannelKey<ModuleStatesStreamable> MODULES =
      ChannelKey.of("application/modules", ModuleStatesStreamable.class);
  /** What modules say to people. */
  public static final ChannelKey<LogLineStreamable> LOG_LINES =
      ChannelKey.of("application/log", LogLineStreamable.class).ofEvery();

  private static final Logger LOG = LoggerFactory.getLogger(RoboApplication.class);
  private static final String ITSELF = "application";
  private static final long MILLION = 1_000_000;
  private static final int GOOD = 1;
  private static final int BROKEN = 3;
  private static final Duration END = Duration.ofSeconds(1);

  private final Blackboard blackboard = new Blackboard();
  private final Router router;
  private final Workers workers;
  private final Map<String, ModuleRunner> modules = new ConcurrentSkipListMap<>();
  private final Map<String, Supplier<? extends RoboModule>> making = new ConcurrentSkipListMap<>();
  private final KeyOutput<ModuleStatesStreamable> states;
  private final KeyOutput<LogLineStreamable> lines;
  private final CountDownLatch closed = new CountDownLatch(1);

  /**
   * Without modules yet.
   *
   * @param name what it is called
   * @param connectors how it comes to others
   * @param threads makes the threads of modules and links
   * @throws IOException where it cannot listen; names the port
   */
  public RoboApplication(String name, List<Connector> connectors, ThreadFactory threads) throws IOException {
    this.router = new Router(blackboard, name, connectors, threads);
    this.workers = new Workers(threads);
    this.states = blackboard.advertise(MODULES, ITSELF);
    this.lines = blackboard.advertise(LOG_LINES, ITSELF);
    say(GOOD, ITSELF, name + " has begun");
    workers.start("roboframe modules", this::look);
  }

  /**
   * Adds a module and lets it begin.
   *
   * @param name no other one has it
   * @param module makes it, on the thread that it runs on; again when it is begun anew
   * @throws IllegalArgumentException where there is one of this name
   */
  public void add(String name, Supplier<? extends RoboModule> module) {
    if (making.putIfAbsent(name, module) != null) {
      throw new IllegalArgumentException("there is a module " + name + " already");
    }
    begin(name);
  }

  private synchronized void begin(String name) {
    if (closed.getCount() > 0) {
      ModuleRunner runner = new ModuleRunner(name, () -> making.get(name).get(), blackboard, this::failed);
      modules.put(name, runner);
      workers.start("roboframe module " + name, runner::live);
    }
  }

  /**
   * Begins a module anew that was stopped by an error.
   *
   * @param name of the module
   * @return false where it still runs, or there is none
   */
  public synchronized boolean restart(String name) {
    ModuleRunner runner = modules.get(name);
    if (runner == null || !runner.isOver()) {
      return false;
    }
    begin(name);
    return true;
  }

  private void failed(String name, Throwable cause) {
    LOG.warn("the module {} was stopped by an error; the others go on", name, cause);
    say(BROKEN, name, "stopped by " + cause.getClass().getSimpleName() + ": " + cause.getMessage());
    tell();
  }

  private void say(int level, String module, String text) {
    lines.push(new LogLineStreamable(System.currentTimeMillis() * MILLION, level, module, text));
  }

  private void look() {
    try {
      do {
        tell();
      } while (!closed.await(1, TimeUnit.SECONDS));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void tell() {
    states.push(new ModuleStatesStreamable(System.currentTimeMillis() * MILLION, states()));
  }

  /**
   * How the modules are doing.
   *
   * @return by their names
   */
  public List<ModuleStateStreamable> states() {
    return modules.values().stream().map(ModuleRunner::state).toList();
  }

  /**
   * The channels of all modules.
   *
   * @return of this application
   */
  public Blackboard blackboard() {
    return blackboard;
  }

  /**
   * The way to other applications.
   *
   * @return of this application
   */
  public Router router() {
    return router;
  }

  /** Lets all modules end, and then the links; bounded where a module hangs. */
  @Override
  public void close() {
    synchronized (this) {
      closed.countDown();
    }
    modules.values().forEach(ModuleRunner::end);
    workers.join(System.nanoTime() + END.toNanos());
    router.close();
  }
}
