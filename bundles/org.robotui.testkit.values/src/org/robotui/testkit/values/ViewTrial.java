package org.robotui.testkit.values;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.TextUic;
import org.robotui.api.Uic;
import org.robotui.api.UicType;
import org.robotui.api.port.Port;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.testkit.Effort;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.display.FakePlaces;
import org.robotui.ui.SwtUic;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/**
 * A view that is shown values which are valid, and values which are not but could be made, until it has painted them:
 * it throws nothing, and its work has a bound. A new view gets it by one line, {@code ViewTrial.of(new MyType())}.
 * Display thread.
 */
public final class ViewTrial {
  private static final int ROUNDS = 60;
  private static final int CHANGES = 3;
  private static final int VALID_EVERY = 8;
  private static final int WIDTH = 640;
  private static final int HEIGHT = 480;
  private static final int MOST_EVENTS = 200;
  private static final int SAID = 3000;

  private final UicType type;
  private final FakeUicContext context;
  private final Spoiler spoiler;
  private final List<Data> valid = ValidValues.all();

  private ViewTrial(UicType type) {
    this.type = type;
    this.context = new FakeUicContext(type.id(), type.schema());
    this.spoiler = new Spoiler(type.id().hashCode());
  }

  /**
   * Shows values in a view of a type, with the settings that it starts with.
   *
   * @param type the type of the view
   * @throws AssertionError where it fails or works without a bound; names the values
   */
  public static void of(UicType type) {
    of(type, context -> {});
  }

  /**
   * Shows values in a view of a type.
   *
   * @param type the type of the view
   * @param prepare gives the view what it needs besides streams: settings, candidates, robots
   * @throws AssertionError where it fails or works without a bound; names the values
   */
  public static void of(UicType type, Consumer<FakeUicContext> prepare) {
    ViewTrial trial = new ViewTrial(type);
    FakeFrames frames = new FakeFrames();
    frames.fix(FakePlaces.frame("map"), FakePlaces.frame("base"), RigidTransform.IDENTITY);
    trial.context.frames(frames);
    prepare.accept(trial.context);
    trial.run();
  }

  private void run() {
    Uic uic = type.create(context, context.settings().current());
    Optional<Theme> theme = uic instanceof SwtUic ? Optional.of(Themes.dark(TestDisplay.get())) : Optional.empty();
    Optional<Shell> shell = theme.map(t -> open((SwtUic) uic, t));
    try {
      for (int round = 0; round < Effort.rounds(ROUNDS); round++) {
        boolean spoils = round % VALID_EVERY != 0;
        List<Given> given = given(spoils);
        try (WorkLimit limit = new WorkLimit(() -> words(given))) {
          given.forEach(Given::put);
          show(uic, shell);
        } catch (RuntimeException | AssertionError e) {
          throw new AssertionError(type.id() + ", round " + round + ": " + words(given), e);
        }
      }
    } finally {
      shell.ifPresent(Shell::dispose);
      theme.ifPresent(Theme::dispose);
      uic.close();
    }
  }

  /** A value for a port. */
  private record Given(FakeInput<Data> input, SourceId source, Data value, Stamp stamp) {
    void put() {
      input.put(source, value, System.nanoTime(), Optional.of(stamp));
    }
  }

  private List<Given> given(boolean spoiled) {
    List<Given> given = new ArrayList<>();
    for (Port port : type.ports()) {
      if (port instanceof StreamPort<?> stream) {
        @SuppressWarnings("unchecked") // only values of its type are put in
        FakeInput<Data> input = (FakeInput<Data>) context.input(stream);
        valid.stream().filter(stream.type()::isInstance)
            .forEach(
                value -> given.add(new Given(input, source(value), spoiled ? spoil(value) : value, stamp(spoiled))));
      }
    }
    return given;
  }

  private Stamp stamp(boolean spoiled) {
    Stamp now = new Stamp(System.nanoTime(), ClockKind.ROBOT);
    return spoiled ? spoiler.spoil(now) : now;
  }

  /**
   * The port from which values of a type come.
   *
   * @param value one of them
   * @return the port of the robot
   */
  public static SourceId source(Data value) {
    return new SourceId("base", value.getClass().getSimpleName());
  }

  private Data spoil(Data value) {
    Data next = value;
    for (int i = 0; i < CHANGES; i++) {
      next = spoiler.spoil(next);
    }
    return next;
  }

  private static Shell open(SwtUic view, Theme theme) {
    Display display = TestDisplay.get();
    Shell shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setSize(WIDTH, HEIGHT);
    view.createControl(shell, UiContext.of(theme, note -> {}));
    shell.open();
    return shell;
  }

  private void show(Uic uic, Optional<Shell> shell) {
    uic.tick(System.nanoTime());
    if (uic instanceof TextUic text) {
      text.lines(80, 24);
    }
    shell.ifPresent(s -> {
      ((SwtUic) uic).refresh();
      paint(s);
      point(s);
      paint(s);
    });
  }

  private static void paint(Shell shell) {
    dispatch(shell.getDisplay());
    shell.redraw(0, 0, WIDTH, HEIGHT, true);
    shell.update();
    dispatch(shell.getDisplay());
  }

  private static void dispatch(Display display) {
    for (int i = 0; i < MOST_EVENTS && display.readAndDispatch(); i++) {
      // a view that paints for ever has painted often enough
    }
  }

  /** What lies under the pointer is described. */
  private static void point(Control control) {
    Event event = new Event();
    event.x = control.getSize().x / 2;
    event.y = control.getSize().y / 2;
    control.notifyListeners(SWT.MouseMove, event);
    control.notifyListeners(SWT.MouseHover, event);
    if (control instanceof Composite parent) {
      for (Control child : parent.getChildren()) {
        point(child);
      }
    }
  }

  private static String words(List<Given> given) {
    String words = given.stream().map(g -> g.source().port() + " " + brief(g.value().toString())).toList().toString();
    return brief(words);
  }

  private static String brief(String words) {
    return words.substring(0, Math.min(SAID, words.length()));
  }
}
