package org.robotui.workbench.internal;

import java.io.File;
import java.nio.file.Files;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.eclipse.core.runtime.ILog;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.Platform;
import org.eclipse.equinox.app.IApplication;
import org.eclipse.equinox.app.IApplicationContext;
import org.eclipse.swt.SWTError;
import org.eclipse.swt.widgets.Display;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.PlatformUI;
import org.robotui.api.UicType.Surface;
import org.robotui.api.bridge.Bridges;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Configuration;
import org.robotui.api.config.Printable;
import org.robotui.api.host.FileOutcome;
import org.robotui.api.host.Host;
import org.robotui.ui.Themes;
import org.robotui.workbench.internal.display.DisplayLoss;
import org.robotui.workbench.internal.display.Heartbeat;
import org.robotui.workbench.internal.display.StopKeys;
import org.robotui.workbench.internal.measure.Measurement;
import org.robotui.workbench.internal.rcp.ErrorLog;
import org.robotui.workbench.internal.rcp.PlatformTheme;
import org.robotui.workbench.internal.rcp.RobotWorkbenchAdvisor;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The workbench. Exit codes: 0 fine, 1 the display was lost, 2 a configuration or a recording cannot be read, 3 wrong
 * arguments, 4 the core did not start, 5 there is no display.
 */
public final class WorkbenchApplication implements IApplication {
  /** How long the end may take, also when a robot hangs. */
  private static final Duration CLOSE_LIMIT = Duration.ofMillis(1200);
  /** How long core and the types of components may take to start. */
  private static final Duration CORE_LIMIT = Duration.ofSeconds(10);
  private static final int UNREADABLE = 2;
  private static final int WRONG_ARGUMENTS = 3;
  private static final int NO_CORE = 4;
  private static final int NO_DISPLAY = 5;
  private static final int ROOM_FOR_LOG = 64 << 10;
  private static final String THEME = "theme";
  private static final Principal USER = new Principal("workbench", "You", Principal.Kind.WINDOW);

  @Override
  public Object start(IApplicationContext context) throws InterruptedException {
    String[] words = (String[]) context.getArguments().get(IApplicationContext.APPLICATION_ARGS);
    try {
      return start(Arguments.parse(words));
    } catch (IllegalArgumentException e) {
      say(e.getMessage());
      return WRONG_ARGUMENTS;
    }
  }

  @Override
  public void stop() {
    if (PlatformUI.isWorkbenchRunning()) {
      IWorkbench workbench = PlatformUI.getWorkbench();
      workbench.getDisplay().asyncExec(workbench::close);
    }
  }

  private static void say(String sentence) {
    System.err.println(Printable.of(sentence));
  }

  /**
   * What cannot be read at all is said where the workbench was started from; where nothing is left to be shown, that is
   * the end.
   */
  private static Object start(Arguments arguments) throws InterruptedException {
    List<String> unreadable = Stream.concat(
        arguments.configurations().stream().flatMap(file -> Configuration.unreadable(file).stream()),
        arguments.files().stream().filter(Predicate.not(Files::exists)).map(file -> "there is no file " + file))
        .toList();
    unreadable.forEach(WorkbenchApplication::say);
    int named = arguments.configurations().size() + arguments.files().size();
    boolean nothingLeft = !unreadable.isEmpty() && unreadable.size() == named;
    Object code = nothingLeft ? EXIT_OK : show(arguments);
    return EXIT_OK.equals(code) && !unreadable.isEmpty() ? UNREADABLE : code;
  }

  private static Object show(Arguments arguments) throws InterruptedException {
    CompletableFuture<Void> components = WorkbenchServices.startLaterBundles(CORE_LIMIT);
    Display display;
    try {
      Display.setAppName("RobotUI");
      display = PlatformUI.createDisplay();
    } catch (SWTError | UnsatisfiedLinkError e) {
      System.err.println(withoutDisplay(e));
      return NO_DISPLAY;
    }
    try {
      Optional<Host> host = WorkbenchServices.host(CORE_LIMIT);
      if (host.isEmpty()) {
        say("the core did not start within " + CORE_LIMIT.toSeconds() + " s");
        return NO_CORE;
      }
      DisplayLoss.watch(display, () -> onDisplayLost(host.get()));
      return run(host.get(), display, arguments, components);
    } finally {
      display.dispose();
    }
  }

  private static String withoutDisplay(Error failure) {
    return failure instanceof UnsatisfiedLinkError
        ? "RobotUI cannot open a window: GTK 3 is not installed, or not wholly (" + missingLibrary(failure)
            + "). On Debian and Ubuntu it is the package libgtk-3-0 or libgtk-3-0t64"
        : "RobotUI cannot open a window: there is no display, or it refuses the connection (DISPLAY is "
            + Optional.ofNullable(System.getenv("DISPLAY")).map(name -> "'" + name + "'").orElse("not set")
            + "). Start it from a desktop session, through ssh -X or by xvfb-run -a, or see it as text: ./robotui run --text";
  }

  /** The toolkit names each place where it looked, a line each; the reason stands in the first that names a file. */
  private static String missingLibrary(Error failure) {
    return failure.getMessage()
        .lines()
        .map(String::strip)
        .filter(line -> line.contains(": "))
        .map(line -> line.substring(line.indexOf(": ") + 2))
        .filter(Predicate.not(String::isBlank))
        .findFirst()
        .orElse("no reason was given");
  }

  private static Object run(Host host, Display display, Arguments arguments, CompletableFuture<Void> components) {
    UserState state = new UserState(UserState.usualFolder());
    String theme = arguments.theme().or(() -> state.get(THEME)).orElse(Themes.DARK);
    host.open(Surface.WINDOW, USER);
    try (ActiveTheme look = new ActiveTheme(display, theme, new PlatformTheme(display)::set)) {
      WorkbenchSession session = new WorkbenchSession(host, USER, display, arguments, state, look, components);
      look.onChange(() -> state.put(THEME, look.choice()));
      components.thenRunAsync(() -> WorkbenchServices.bridges().ifPresent(Bridges::start),
          task -> Thread.ofPlatform().daemon().name("robotui-start").start(task));
      return run(session, display);
    }
  }

  private static Object run(WorkbenchSession session, Display display) {
    Runnable withdraw = WorkbenchServices.publish(session);
    Runnable unheard = WorkbenchServices.listen(session::installed);
    Runnable unfollowed = WorkbenchServices.timelines(session.timeline()::follow);
    Optional<Measurement> measurement =
        session.arguments().measure().map(file -> new Measurement(session.host(), display, file));
    Optional<WindowScripts> scripts = Optional.empty();
    CountDownLatch ended = new CountDownLatch(1);
    Runtime.getRuntime().addShutdownHook(new Thread(() -> onSignal(session.host(), display, ended), "robotui-stop"));
    Optional<ErrorLog> errors =
        ErrorLog.open(LoggerFactory.getILoggerFactory(), WorkbenchApplication::tellPlatform);
    try (Heartbeat heartbeat = new Heartbeat(session.host(), display);
        StopKeys keys = new StopKeys(display, session::stop)) {
      AtomicInteger exit = new AtomicInteger(EXIT_OK);
      RobotWorkbenchAdvisor advisor =
          new RobotWorkbenchAdvisor(session, heartbeat::begin, outcome -> opened(outcome, exit));
      scripts = WindowScripts.of(session, System.out, System.err, code -> {
        exit.set(code);
        display.asyncExec(PlatformUI.getWorkbench()::close);
      });
      advisor.startRobots();
      int code = PlatformUI.createAndRunWorkbench(display, advisor);
      return code == PlatformUI.RETURN_RESTART ? EXIT_RESTART : exit.get();
    } finally {
      scripts.ifPresent(WindowScripts::close);
      measurement.ifPresent(Measurement::close);
      session.close();
      end(session.host(), display);
      unfollowed.run();
      unheard.run();
      withdraw.run();
      errors.ifPresent(ErrorLog::close);
      ended.countDown();
    }
  }

  /** What the command line names is said there where it cannot be opened; what is missing was said already. */
  private static void opened(FileOutcome outcome, AtomicInteger exit) {
    if (outcome instanceof FileOutcome.NotOpened refused) {
      exit.compareAndSet(EXIT_OK, UNREADABLE);
      if (Files.exists(refused.file())) {
        say(refused.reason());
      }
    }
  }

  /**
   * The windows have gone; what we drive is stopped on a worker while the display still serves those who wait for it.
   */
  private static void end(Host host, Display display) {
    CompletableFuture<Void> ended = CompletableFuture.runAsync(() -> {
      WorkbenchServices.bridges().ifPresent(Bridges::stop);
      host.close(CLOSE_LIMIT).forEach(left -> log().warn("not ended in time: {}", left));
    }, task -> Thread.ofPlatform().daemon().name("robotui-close").start(task));
    ended.whenComplete((nothing, failure) -> wake(display));
    while (!ended.isDone()) {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
    if (ended.isCompletedExceptionally()) {
      log().error("the core could not be closed", ended.exceptionNow());
    }
  }

  /**
   * Not made with the class: the first logger of all takes a while, and core asks for one beside the start of the
   * display.
   */
  private static Logger log() {
    return LoggerFactory.getLogger(WorkbenchApplication.class);
  }

  /** Where its log cannot be written, the platform would print its own failure, stack and all. */
  private static void tellPlatform(IStatus status) {
    File folder = Platform.getLogFileLocation().toFile().getParentFile();
    if (folder.getUsableSpace() > ROOM_FOR_LOG) {
      ILog.of(WorkbenchApplication.class).log(status);
    }
  }

  private static void wake(Display display) {
    if (!display.isDisposed()) {
      display.wake();
    }
  }

  /** There is no window any more that could be closed; the robots are left as if there were. */
  private static void onDisplayLost(Host host) {
    say("RobotUI has lost its display: what it drove is stopped, and its robots are left");
    host.close(CLOSE_LIMIT).forEach(left -> log().warn("not ended in time: {}", left));
  }

  /** Ctrl-C and SIGTERM: the process lives until the robots are stopped. */
  private static void onSignal(Host host, Display display, CountDownLatch ended) {
    try {
      if (ended.getCount() > 0 && !display.isDisposed() && PlatformUI.isWorkbenchRunning()) {
        Duration limit = host.closeLimit(CLOSE_LIMIT);
        display.asyncExec(PlatformUI.getWorkbench()::close);
        ended.await(limit.toMillis() + 400, TimeUnit.MILLISECONDS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
