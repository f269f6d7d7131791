package org.robotui.headless.internal;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.eclipse.equinox.app.IApplication;
import org.eclipse.equinox.app.IApplicationContext;
import org.osgi.framework.FrameworkUtil;
import org.robotui.api.host.Host;
import org.robotui.install.FeatureInstaller;

/** The application without a window: shows robots in a terminal or as JSON lines, or checks a configuration. */
public final class HeadlessApplication implements IApplication {
  private static final Duration CORE_LIMIT = Duration.ofSeconds(10);

  private final PrintStream out = new TerminalOut(System.out, StandardCharsets.UTF_8);
  private final PrintStream err = new TerminalOut(System.err, System.err.charset());
  private final CountDownLatch stop = new CountDownLatch(1);
  private final CountDownLatch ended = new CountDownLatch(1);

  @Override
  public Object start(IApplicationContext context) throws InterruptedException {
    String[] words = (String[]) context.getArguments().get(IApplicationContext.APPLICATION_ARGS);
    context.applicationRunning();
    try {
      return run(Arrays.asList(words)).code();
    } catch (Arguments.Wrong e) {
      err.println(e.getMessage());
      err.print(Arguments.USAGE);
      err.print(NewArguments.USAGE);
      err.print(FeatureArguments.USAGE);
      return Exit.USAGE.code();
    } finally {
      out.flush();
      err.flush();
      ended.countDown();
    }
  }

  @Override
  public void stop() {
    stop.countDown();
  }

  private Exit run(List<String> words) throws Arguments.Wrong, InterruptedException {
    if (words.contains("-new")) {
      return compose(NewArguments.parse(words));
    }
    return !words.isEmpty() && words.getFirst().equals(FeatureArguments.OPTION)
        ? change(FeatureArguments.parse(words))
        : run(Arguments.parse(words.toArray(String[]::new)));
  }

  private Exit change(FeatureArguments wanted) throws InterruptedException {
    try (AwaitedService<FeatureInstaller> service = service(FeatureInstaller.class)) {
      Optional<FeatureInstaller> installer = service.await(CORE_LIMIT);
      if (installer.isEmpty()) {
        err.println("the installer did not start within " + CORE_LIMIT.toSeconds() + " s");
        return Exit.NO_CORE;
      }
      BufferedReader answers = new BufferedReader(new InputStreamReader(System.in, Charset.defaultCharset()));
      return new FeatureRun(installer.get(), out, err, answers).run(wanted);
    }
  }

  private <S> AwaitedService<S> service(Class<S> type) {
    return new AwaitedService<>(FrameworkUtil.getBundle(getClass()).getBundleContext(), type);
  }

  private Exit compose(NewArguments wanted) throws InterruptedException {
    return withHost(host -> new NewRun(host, out, err).run(wanted));
  }

  private Exit run(Arguments arguments) throws InterruptedException {
    return withHost(host -> run(host, arguments));
  }

  /** What is done with the core. */
  private interface Task {
    Exit run(Host host) throws InterruptedException;
  }

  private Exit withHost(Task task) throws InterruptedException {
    try (AwaitedService<Host> service = service(Host.class)) {
      Optional<Host> host = service.await(CORE_LIMIT);
      if (host.isEmpty()) {
        err.println("the core did not start within " + CORE_LIMIT.toSeconds() + " s");
        return Exit.NO_CORE;
      }
      return task.run(host.get());
    }
  }

  private Exit run(Host host, Arguments arguments) throws InterruptedException {
    if (arguments.check().isPresent()) {
      return new CheckRun(host, out, err).check(arguments.check().get(), arguments.live(), arguments.reuse());
    }
    Thread hook = new Thread(() -> stopAndWait(host), "robotui-stop");
    Runtime.getRuntime().addShutdownHook(hook);
    return new ShowRun(host, out, err, stop).show(arguments);
  }

  /** Ctrl-C and SIGTERM come here: the process lives until what we drive is stopped. */
  private void stopAndWait(Host host) {
    Duration limit = host.closeLimit(ShowRun.CLOSE_LIMIT);
    stop.countDown();
    try {
      ended.await(limit.toMillis() + 500, java.util.concurrent.TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
