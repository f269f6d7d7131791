package org.robotui.uic.log.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  private static final String[] NODES =
      {"/amcl", "/move_base", "/hokuyo_node", "/robot_state_publisher", "/arm/controller_manager"};
  private static final String[] TEXTS = {
      "Subscribed to map topic.", "Got new plan with 132 poses",
      "Control loop missed its desired rate of 20.0000Hz... the loop actually took 0.0812 seconds",
      "Buffer under-run; scan 18231 was dropped",
      "Costmap2DROS transform timeout. Current time: 1433.22, global_pose stamp: 1432.64",
      "Rotate recovery behavior started.\nThe robot could not find a way for 10.0 s.\n  cells cleared: 132\n  radius: 0.55 m",
      "goal reached"};
  private static final Severity[] LEVELS =
      {Severity.INFO, Severity.DEBUG, Severity.WARNING, Severity.ERROR, Severity.WARNING,
          Severity.INFO, Severity.INFO};

  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 1060, 440, c -> {
      c.settings().set(LogType.NODES, true);
      talk(c, 4321);
    });
    cell(1066, 0, 534, 216,
        c -> c.input(LogType.LOG).state(new InputState.Unconnected("log needs LogEntry; base offers none.")));
    cell(1066, 222, 534, 218,
        c -> c.input(LogType.LOG).state(new InputState.Waiting("/rosout has 5 publishers, nothing was said yet")));
    LogUic chosen = cell(0, 446, 760, 330, c -> {
      c.settings().set(LogType.SEARCH, "rec[ov]+ery|loop");
      c.settings().set(LogType.EXPRESSION, true);
      talk(c, 200);
    });
    chosen.refresh();
    press(window.made(3), 60);
    cell(766, 446, 500, 330, c -> {
      c.settings().set(LogType.SEARCH, "go(al");
      c.settings().set(LogType.EXPRESSION, true);
      c.settings().set(LogType.COLLAPSE, true);
      talk(c, 60);
      c.input(LogType.LOG).state(new InputState.Stale(12.3, "the link is lost"));
    });
    cell(1272, 446, 328, 330, c -> talk(c, 60));
    cell(0, 782, 500, 218, c -> {
      talk(c, 60);
      c.settings().set(LogType.SEARCH, "nowhere to be found");
    });
    cell(506, 782, 500, 218, c -> {
      c.settings().set(LogType.LEVELS, List.of("warning", "fatal"));
      talk(c, 60);
      c.input(LogType.LOG)
          .put(new LogEntry(Severity.FATAL, "/base_driver", "Emergency stop: motor controller does not answer", ""));
      c.input(LogType.LOG).state(new InputState.Stale(12.3, "the link to localhost:11311 is lost"));
    });
    LogUic paused = cell(1012, 782, 588, 218, c -> talk(c, 90));
    paused.actions().getFirst().run().run();
    paused.tick(System.nanoTime());
    paused.refresh();
  }

  private static void press(Control part, int y) {
    Control list = deepest(part);
    Event down = new Event();
    down.button = 1;
    down.x = 200;
    down.y = y;
    list.notifyListeners(SWT.MouseDown, down);
  }

  /** The list is the one with the most room. */
  private static Control deepest(Control control) {
    Control best = control;
    if (control instanceof Composite composite) {
      for (Control child : composite.getChildren()) {
        if (child.getSize().x > 300 && child.getSize().y > 100) {
          return deepest(child);
        }
      }
    }
    return best;
  }

  private static void talk(FakeUicContext context, int count) {
    long now = System.currentTimeMillis() * 1_000_000L;
    for (int i = 0; i < count; i++) {
      int kind = i * 7919 % 31 % TEXTS.length;
      if (i % 9 == 8) {
        kind = 2;
      }
      int times = kind == 3 ? 4 : 1;
      for (int k = 0; k < times; k++) {
        context.input(LogType.LOG).put(new SourceId("base", "/rosout"),
            new LogEntry(LEVELS[kind], NODES[kind % NODES.length], TEXTS[kind], "src/planner_core.cpp:" + (100 + kind)),
            System.nanoTime(),
            Optional.of(new Stamp(now - (count - i) * 120_000_000L, ClockKind.ROBOT)));
      }
    }
  }

  private LogUic cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare) {
    FakeUicContext context = new FakeUicContext("log", new LogType().schema());
    prepare.accept(context);
    Composite part = window.cell(x, y, width, height);
    LogUic uic = new LogUic(context);
    uic.tick(System.nanoTime());
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
    uic.refresh();
    return uic;
  }
}
