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
import org.robotui.api.bridge.Bridges;
import org.robotui.api.host.Host;
import org.robotui.api.record.Recorder;
import org.robotui.api.script.Scripts;
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
      return run(Arrays.asList(words));
    } catch (Arguments.Wrong e) {
      err.println(e.getMessage());
      err.print(Arguments.USAGE);
      err.print(RecordArguments.USAGE);
      err.print(BridgeArguments.USAGE);
      err.print(NewArguments.USAGE);
      err.print(FeatureArguments.USAGE);
      err.print(WordsArguments.USAGE);
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

  private int run(List<String> words) throws Arguments.Wrong, InterruptedException {
    if (words.contains("-new")) {
      return compose(NewArguments.parse(words));
    }
    if (words.contains(WordsArguments.OPTION)) {
      WordsArguments wanted = WordsArguments.parse(words);
      return with(Host.class, "the core", host -> new WordsRun(host, out, err).run(wanted).code());
    }
    if (words.contains(BridgeArguments.OPTION)) {
      return bridge(BridgeArguments.parse(words));
    }
    if (words.contains(RecordArguments.OPTION)) {
      return record(RecordArguments.parse(words));
    }
    return !words.isEmpty() && words.getFirst().equals(FeatureArguments.OPTION)
        ? change(FeatureArguments.parse(words))
        : run(Arguments.parse(words.toArray(String[]::new)));
  }

  private int record(RecordArguments wanted) throws InterruptedException {
    return with(Host.class, "the core", host -> {
      endInOrder(host);
      return with(Recorder.class, "the recorder", recorder -> new ShowRun(host, out, err, stop, Optional.empty())
          .show(wanted.rest(), Optional.of(() -> new RecordRun(recorder, out, err, stop).run(wanted).code())));
    });
  }

  private int bridge(BridgeArguments wanted) throws InterruptedException {
    return with(Host.class, "the core", host -> {
      endInOrder(host);
      return with(Bridges.class, "what runs bridges",
          bridges -> new ShowRun(host, out, err, stop, Optional.empty()).show(wanted.rest(),
              Optional.of(() -> new BridgeRun(host, bridges, out, err, stop).run(wanted).code())));
    });
  }

  private int change(FeatureArguments wanted) throws InterruptedException {
    BufferedReader answers = new BufferedReader(new InputStreamReader(System.in, Charset.defaultCharset()));
    return with(FeatureInstaller.class, "the installer",
        installer -> new FeatureRun(installer, out, err, answers).run(wanted).code());
  }

  private int compose(NewArguments wanted) throws InterruptedException {
    return with(Host.class, "the core", host -> new NewRun(host, out, err).run(wanted).code());
  }

  private int run(Arguments arguments) throws InterruptedException {
    return with(Host.class, "the core", host -> run(host, arguments));
  }

  /** What is done with a service; answers the exit code. */
  private interface Task<S> {
    int run(S service) throws InterruptedException;
  }

  private <S> int with(Class<S> type, String what, Task<S> task) throws InterruptedException {
    try (AwaitedService<S> awaited =
        new AwaitedService<>(FrameworkUtil.getBundle(getClass()).getBundleContext(), type)) {
      Optional<S> service = awaited.await(CORE_LIMIT);
      if (service.isEmpty()) {
        err.println(what + " did not start within " + CORE_LIMIT.toSeconds() + " s");
        return Exit.NO_CORE.code();
      }
      return task.run(service.get());
    }
  }

  private int run(Host host, Arguments arguments) throws InterruptedException {
    if (arguments.check().isPresent()) {
      return new CheckRun(host, out, err).check(arguments.check().get(), arguments.live(), arguments.reuse()).code();
    }
    endInOrder(host);
    return arguments.usesScripts()
        ? with(Scripts.class, "what runs scripts", scripts -> show(host, arguments, Optional.of(scripts)))
        : show(host, arguments, Optional.empty());
  }

  private int show(Host host, Arguments arguments, Optional<Scripts> scripts) throws InterruptedException {
    return new ShowRun(host, out, err, stop, scripts).show(arguments);
  }

  private void endInOrder(Host host) {
    Runtime.getRuntime().addShutdownHook(new Thread(() -> stopAndWait(host), "robotui-stop"));
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
