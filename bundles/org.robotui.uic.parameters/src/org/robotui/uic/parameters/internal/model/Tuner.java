package org.robotui.uic.parameters.internal.model;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.Browser.Tunable;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.ui.ask.ControlFirst;

/**
 * The settings of one running program: read slowly, and set as fast as the user drags but at most ten times a second.
 * The last value is always sent. All threads.
 */
public final class Tuner {
  private static final long SEND_NANOS = 100_000_000L;

  private final Key server;
  private final Item item;
  private final Browser browser;
  private final Executor background;
  private final ControlFirst control;
  private final Map<String, Object> wanted = new LinkedHashMap<>();
  private final Map<String, Object> sent = new HashMap<>();
  private final Map<String, String> problems = new HashMap<>();
  private List<Tunable> settings = List.of();
  private Optional<String> failure = Optional.empty();
  private boolean known;
  private boolean busy;
  private boolean asking;
  private boolean everSent;
  private boolean everRead;
  private long sentAt;
  private long readAt;

  Tuner(Key server, Browser browser, Executor background, ControlFirst control) {
    this.server = server;
    this.item = new Item(Kind.TUNABLE, server.name(), "");
    this.browser = browser;
    this.background = background;
    this.control = control;
  }

  /** Sets a setting soon; a value that comes later replaces it. */
  public void set(String name, Object value) {
    boolean ask;
    synchronized (this) {
      wanted.put(name, value);
      problems.remove(name);
      ask = !asking && !control.isMine(server.robot());
      asking |= ask;
    }
    if (ask) {
      control.with(server.robot(), this::go, this::giveUp);
    }
  }

  /** Says that what was typed is no value of a setting. */
  public synchronized void wrong(String name, String why) {
    problems.put(name, why);
  }

  /** Sets all settings to their defaults. */
  public void restore() {
    knobs().stream().filter(knob -> !knob.isDefault())
        .forEach(knob -> set(knob.tunable().name(), knob.tunable().fallback()));
  }

  /** Sends or reads what is due. */
  synchronized void tick(long now, long periodNanos) {
    if (busy || asking) {
      return;
    }
    if (!wanted.isEmpty()) {
      if (!everSent || now - sentAt >= SEND_NANOS) {
        send(now);
      }
    } else if (!everRead || now - readAt >= periodNanos) {
      everRead = true;
      readAt = now;
      start(() -> browser.tunables(item));
    }
  }

  /** What the form shows. */
  public synchronized Panel panel() {
    return new Panel(server, knobs(), known, failure);
  }

  Key server() {
    return server;
  }

  private synchronized List<Knob> knobs() {
    return settings.stream().map(t -> new Knob(t, wanted.getOrDefault(t.name(), sent.getOrDefault(t.name(), t.value())),
        wanted.containsKey(t.name()) || sent.containsKey(t.name()), Optional.ofNullable(problems.get(t.name()))))
        .toList();
  }

  private void send(long now) {
    everSent = true;
    sentAt = now;
    readAt = now;
    sent.putAll(wanted);
    wanted.clear();
    Map<String, Object> values = Map.copyOf(sent);
    start(() -> browser.setTunables(item, values));
  }

  /** Asks the program; the answer is what it has then. */
  private interface Question {
    List<Tunable> ask() throws CallException;
  }

  private void start(Question question) {
    busy = true;
    background.execute(() -> {
      try {
        answered(question.ask());
      } catch (CallException e) {
        failed(e.getMessage());
      } finally {
        idle();
      }
    });
  }

  private synchronized void answered(List<Tunable> now) {
    settings = List.copyOf(now);
    known = true;
    failure = Optional.empty();
    sent.clear();
  }

  private synchronized void failed(String why) {
    if (sent.isEmpty()) {
      failure = Optional.of(why);
    } else {
      sent.keySet().forEach(name -> problems.put(name, why));
      sent.clear();
    }
  }

  private synchronized void idle() {
    busy = false;
  }

  private synchronized void go() {
    asking = false;
  }

  private synchronized void giveUp() {
    asking = false;
    wanted.clear();
  }
}
