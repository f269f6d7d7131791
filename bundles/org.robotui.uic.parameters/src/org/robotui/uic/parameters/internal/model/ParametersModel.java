package org.robotui.uic.parameters.internal.model;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.api.UicContext;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.ask.ControlFirst;
import org.robotui.ui.ask.Presence;
import org.robotui.uic.parameters.internal.ParametersOptions;
import org.robotui.uic.parameters.internal.ParametersPorts;

/**
 * The parameters of robots and the settings of their running programs. The tick prepares what is seen; all that asks a
 * robot runs in the background. Wishes may be said on any thread.
 */
public final class ParametersModel {
  private static final long SEEN_NANOS = 3_000_000_000L;
  private static final long HEARTBEAT_NANOS = 1_000_000_000L;
  private static final int MOST_EXPORTED = 20_000;

  private final UicContext context;
  private final BrowseInput browse;
  private final Directory.Lister lister = new Directory.Lister();
  private final AtomicBoolean listing = new AtomicBoolean();
  private final Values values;
  private final RowMaker maker;
  private final Presence presence;
  private final ControlFirst control;
  private final Undo undo = new Undo();
  private final Set<Key> open = new HashSet<>();
  private volatile Directory directory = Directory.NOTHING;
  private volatile Optional<Tuner> tuner = Optional.empty();
  private volatile List<Key> visible = List.of();
  private volatile String filter = "";
  private volatile ParameterNotice told = ParameterNotice.NOTHING;
  private volatile boolean tuning;
  private volatile boolean seen;
  private volatile boolean dirty = true;
  private volatile long seenAt;
  private volatile long listAt;
  private volatile boolean listed;
  private volatile ParametersViewState look;
  private Directory shown = Directory.NOTHING;
  private long version = -1;
  private long beatAt;

  /** With what core gives to the view. */
  public ParametersModel(UicContext context) {
    this.context = context;
    browse = context.browse(ParametersPorts.GRAPH);
    values = new Values(this::browser, context.background());
    maker = new RowMaker(values);
    presence = new Presence(context, ParametersPorts.GRAPH, "its parameters");
    control = new ControlFirst(context);
    look = look(List.of());
  }

  /** Asks what is due and prepares what is seen; whether there is something new to show. */
  public boolean tick(long now, ParametersOptions options) {
    if (seen && now - seenAt < SEEN_NANOS) {
      list(now, options.names().toNanos());
      if (tuning) {
        tuner.ifPresent(t -> t.tick(now, options.values().toNanos()));
      } else {
        values.tick(now, visible, options.values().toNanos());
      }
    }
    boolean changed = prepare();
    boolean beat = now - beatAt >= HEARTBEAT_NANOS;
    beatAt = beat ? now : beatAt;
    return changed || beat;
  }

  private boolean prepare() {
    boolean again = dirty || directory != shown || values.version() != version;
    dirty = false;
    shown = directory;
    version = values.version();
    ParametersViewState next = look(again ? rows() : look.rows());
    boolean changed = again || !next.equals(look);
    look = next;
    return changed;
  }

  /** What the last tick prepared. */
  public ParametersViewState look() {
    return look;
  }

  /** All parameters that are known, robot after robot. */
  public List<Key> parameters() {
    return directory.trees().stream().flatMap(tree -> tree.parameters().stream()).toList();
  }

  /** Takes control where that has to be asked. */
  public ControlFirst control() {
    return control;
  }

  /** The settings of the chosen program. */
  public Optional<Tuner> tuner() {
    return tuner;
  }

  /** The view is seen now: robots are asked for as long as it is. */
  public void seen(long now, List<Key> rows) {
    visible = rows;
    seenAt = now;
    seen = true;
  }

  /** The view is not seen any more: nothing is asked for. */
  public void gone() {
    seen = false;
  }

  /** Shows running programs in place of parameters, or parameters again. */
  public void tuning(boolean on) {
    tuning = on;
  }

  /** Shows only what contains all these words in its name or its known value. */
  public void filter(String words) {
    filter = words;
    dirty = true;
  }

  /** Shows what lies in a namespace, or hides it. */
  public void open(Key key, boolean wanted) {
    synchronized (open) {
      if (wanted) {
        open.add(key);
      } else {
        open.remove(key);
      }
    }
    dirty = true;
  }

  /** Chooses the program whose settings are shown. */
  public void tune(Optional<Key> server) {
    if (!server.equals(tuner.map(Tuner::server))) {
      tuner = server
          .flatMap(key -> browser(key.robot()).map(browser -> new Tuner(key, browser, context.background(), control)));
    }
  }

  /** Reads all again: names, and the values that are seen. */
  public void refresh() {
    listed = false;
    values.expire();
  }

  /** Sets a parameter, as soon as the user has control. */
  public void set(Key key, Object value) {
    Optional<Object> before = values.get(key).flatMap(Held::value);
    change(key, value, () -> before.ifPresent(old -> undo.push(new Undo.Change(key, old))), "Set ");
  }

  /** Changes back what was changed last. */
  public void undo() {
    undo.peek().ifPresent(last -> change(last.key(), last.before(), () -> undo.drop(last), "Set back "));
  }

  /** Says what is wrong with what was typed. */
  public void tell(Health health, String text) {
    told = new ParameterNotice(health, text);
  }

  /** Writes the parameters of a namespace to a file that the robot's tools can load. */
  public void export(Key namespace, Path file) {
    List<Key> keys = directory.find(namespace).map(Branch::parameters).orElse(List.of());
    told = new ParameterNotice(Health.WAITING, "Reading " + keys.size() + " parameters");
    context.background().execute(() -> told = exported(namespace, keys, file));
  }

  /** How many branches were looked at so far, for tests of what it costs. */
  long looked() {
    return maker.looked();
  }

  private void change(Key key, Object value, Runnable done, String what) {
    control.with(key.robot(), () -> {
      values.busy(key);
      context.background().execute(() -> write(key, value, done, what));
    }, () -> told = new ParameterNotice(Health.NONE, key.name() + " was not changed"));
  }

  private void write(Key key, Object value, Runnable done, String what) {
    try {
      values.write(key, value);
      done.run();
      told = new ParameterNotice(Health.OK, what + key.name());
    } catch (CallException e) {
      values.wrong(key, e.getMessage());
      told = new ParameterNotice(Health.BAD, key.name() + " was not set: " + e.getMessage());
    }
  }

  private ParameterNotice exported(Key namespace, List<Key> keys, Path file) {
    try {
      if (keys.size() > MOST_EXPORTED) {
        return new ParameterNotice(Health.BAD, "More than " + MOST_EXPORTED + " parameters are too many for one file");
      }
      Map<String, Object> found = new LinkedHashMap<>();
      for (Key key : keys) {
        values.read(key).ifPresent(value -> found.put(key.name(), value));
      }
      AtomicFile.write(file, YamlFile.of(namespace.name(), found));
      return new ParameterNotice(Health.OK, found.size() + " parameters written to " + file.getFileName());
    } catch (CallException e) {
      return new ParameterNotice(Health.BAD, "Nothing was written: " + e.getMessage());
    } catch (IOException e) {
      return new ParameterNotice(Health.BAD, file + " could not be written: " + WriteFailure.reason(e));
    }
  }

  private void list(long now, long periodNanos) {
    if ((!listed || now - listAt >= periodNanos) && listing.compareAndSet(false, true)) {
      listed = true;
      listAt = now;
      context.background().execute(() -> {
        try {
          directory = lister.list(browse.robots());
        } finally {
          listing.set(false);
        }
      });
    }
  }

  private List<ParameterRow> rows() {
    Set<Key> opened;
    synchronized (open) {
      opened = Set.copyOf(open);
    }
    return maker.rows(directory, opened, filter);
  }

  private ParametersViewState look(List<ParameterRow> rows) {
    Directory now = directory;
    InputState state = presence.state(now.known(), now.failures());
    return new ParametersViewState(tuning, state, rows, now.parameters(), filter, now.servers(),
        tuner.map(Tuner::panel),
        Presence.notice(state, now.failures()), told, control.question(),
        undo.peek().map(last -> last.key().name()).orElse(""));
  }

  private Optional<Browser> browser(String robot) {
    return browse.robots().stream().filter(r -> r.source().component().equals(robot)).map(BrowseInput.Robot::browser)
        .findFirst();
  }
}
