package org.robotui.script.internal.action;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.robotui.api.host.Host;
import org.robotui.api.script.ActionWatch;
import org.robotui.api.script.ScriptFunctions;
import org.robotui.api.script.Scripts.ActionRecording;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Asks all that see what users do, and waits in the script where the user waited. */
public final class ActionRecorder implements ActionRecording {
  private static final Logger LOG = LoggerFactory.getLogger(ActionRecorder.class);
  private static final Duration LOOK = Duration.ofMillis(200);
  private static final Duration END = Duration.ofSeconds(2);
  /** Shorter ones are none of the user's. */
  private static final double SHORTEST_WAIT = 0.5;

  private final List<ActionWatch> watches = new CopyOnWriteArrayList<>();
  private final CommandWatch commands;
  private final Consumer<String> line;
  private final Thread thread = new Thread(this::look, "robotui-script-actions");
  private Optional<Long> last = Optional.empty();

  /**
   * Begins at once.
   *
   * @param host is watched
   * @param functions those of bundles
   * @param line takes each line
   */
  public ActionRecorder(Host host, List<ScriptFunctions> functions, Consumer<String> line) {
    this.line = line;
    commands = new CommandWatch(host);
    watches.add(new HostWatch(host));
    functions.forEach(f -> f.watch().ifPresent(watches::add));
    thread.setDaemon(true);
    thread.start();
  }

  private void look() {
    while (waited()) {
      said(System.nanoTime());
    }
    said(System.nanoTime());
    add(commands.end(System.nanoTime()), System.nanoTime());
  }

  private static boolean waited() {
    try {
      Thread.sleep(LOOK);
      return true;
    } catch (InterruptedException e) {
      return false;
    }
  }

  private void said(long now) {
    // Control is taken before something is sent, and given back or stopped after it.
    List<CommandWatch.Done> sent = commands.next(now);
    List<CommandWatch.Done> others = watches.stream().flatMap(watch -> next(watch).stream())
        .map(words -> new CommandWatch.Done(words, 0)).toList();
    boolean begins = others.stream().anyMatch(d -> d.line().startsWith("takeControl("));
    add(Stream.concat((begins ? others : sent).stream(), (begins ? sent : others).stream()).toList(), now);
  }

  private void add(List<CommandWatch.Done> done, long now) {
    if (done.isEmpty()) {
      return;
    }
    double took = done.stream().mapToDouble(CommandWatch.Done::seconds).sum();
    double waited = last.map(before -> (now - before) / 1e9 - took).orElse(0.0);
    if (waited >= SHORTEST_WAIT) {
      line.accept(String.format(Locale.ROOT, "sleep(%.1f);", waited));
    }
    last = Optional.of(now);
    done.forEach(d -> line.accept(d.line()));
  }

  /** One that fails is left out from then on, and hides nothing of the others. */
  private List<String> next(ActionWatch watch) {
    try {
      return watch.next();
    } catch (RuntimeException e) {
      LOG.warn("what users do cannot be asked of {}", watch.getClass().getName(), e);
      watches.remove(watch);
      return List.of();
    }
  }

  @Override
  public void close() {
    thread.interrupt();
    try {
      thread.join(END);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
