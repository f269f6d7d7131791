package org.robotui.uic.log.internal;

import java.nio.file.Path;
import java.time.Clock;
import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.show.Subject;
import org.robotui.data.status.LogEntry;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.log.internal.model.LogFile;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.LogLine;
import org.robotui.uic.log.internal.model.LogModel;
import org.robotui.uic.log.internal.model.Wording;
import org.robotui.uic.log.internal.view.Frame;
import org.robotui.uic.log.internal.view.LogHands;
import org.robotui.uic.log.internal.view.LogSurface;

/** The view: the tick takes and filters, the surface lists. */
final class LogUic extends SurfaceUic<LogSurface> {
  private static final long TOLD_NANOS = 6_000_000_000L;

  private final UicContext context;
  private final Input<LogEntry> input;
  private final LogModel model;
  private final Wording wording = new Wording(ZoneId.systemDefault());
  private final Hands hands = new Hands();
  private volatile Optional<Told> told = Optional.empty();
  private volatile Frame frame;

  LogUic(UicContext context) {
    this.context = context;
    this.input = context.input(LogType.LOG);
    this.model = new LogModel(input, Clock.systemUTC(), System::nanoTime);
    model.filter(LogPreferences.read(context.settings().current()));
    this.frame = frame();
    offers().add("pause", "Pause", Icon.PAUSE, model::paused, () -> hands.pause(!model.paused()))
        .add("collapse", "Collapse equal entries in a row", Icon.LAYERS, () -> model.filter().collapse(),
            () -> hands.filter(model.filter().collapse(!model.filter().collapse())))
        .add("show_all", "Show all levels and nodes, and end the search", Icon.EYE, hands::showAll)
        .action("save", "Save what is shown as text\u2026", Icon.SAVE, LogSurface::save)
        .add("clear", "Clear", Icon.RESTART, hands::clear);
  }

  @Override
  public boolean tick(long now) {
    Settings settings = context.settings().current();
    boolean news = model.tick(now, (int) settings.integer(LogType.CAPACITY), settings.integer(LogType.MEMORY));
    told = told.filter(t -> now - t.at < TOLD_NANOS);
    Frame next = frame();
    boolean changed = news || !next.looksLike(frame);
    frame = next;
    return changed;
  }

  @Override
  protected LogSurface open(Composite parent, UiContext ui) {
    return new LogSurface(parent, ui, wording, hands,
        new SubjectMenu(context, ui.theme()));
  }

  @Override
  protected void refresh(LogSurface shown) {
    shown.show(frame);
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("P", "Pause or resume"),
        new ViewKey("Ctrl+F, /", "Search"),
        new ViewKey("Ctrl+C", "Copy the selected entries"),
        new ViewKey("Esc", "Close the details"));
  }

  @Override
  public void show(String showing, Subject subject) {
    if (subject instanceof Subject.Node node) {
      hands.filter(model.filter().cleared().onlyOrigin(node.name()));
    }
  }

  private Frame frame() {
    InputState state = input.state();
    return new Frame(model.current(), model.filter(), state, model.paused(),
        context.settings().current().flag(LogType.NODES),
        told.map(Told::words).orElse(""));
  }

  private record Told(String words, long at) {}

  /** What the user can do. Display thread. */
  private final class Hands implements LogHands {
    @Override
    public void filter(LogFilter next) {
      model.filter(next);
      LogPreferences.write(context.settings(), next);
      now();
    }

    @Override
    public void showAll() {
      filter(model.filter().cleared());
    }

    @Override
    public void pause(boolean on) {
      model.pause(on);
      now();
    }

    @Override
    public void clear() {
      model.clear();
    }

    @Override
    public void nodes(boolean shown) {
      context.settings().set(LogType.NODES, shown);
      now();
    }

    @Override
    public void save(List<LogLine> lines, Path file) {
      context.background()
          .execute(() -> told = Optional.of(new Told(LogFile.write(lines, wording, file), System.nanoTime())));
    }

    private void now() {
      frame = frame();
      refresh();
    }
  }
}
