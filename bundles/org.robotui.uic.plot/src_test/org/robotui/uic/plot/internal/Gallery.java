package org.robotui.uic.plot.internal;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.testkit.KeptHistory;
import org.robotui.testkit.KeptTimeline;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.plot.internal.model.PlotOptions;

/**
 * Shows the view in all its states side by side, for a person to look at:
 * {@code Gallery dark|light [2|recorded|curves]}.
 */
final class Gallery {
  private final GalleryWindow window;
  private final Theme theme;

  private Gallery(GalleryWindow window, Theme theme) {
    this.window = window;
    this.theme = theme;
  }

  public static void main(String[] arguments) {
    Display display = new Display();
    Theme theme = Themes.of(display, arguments[0]);
    GalleryWindow window = new GalleryWindow(display, theme.color(Role.LINE));
    Gallery gallery = new Gallery(window, theme);
    if (arguments.length > 1 && arguments[1].equals("recorded")) {
      gallery.fillRecorded();
    } else if (arguments.length > 1 && arguments[1].equals("curves")) {
      gallery.fillCurves();
    } else if (arguments.length > 1) {
      gallery.fillMore();
    } else {
      gallery.fill();
    }
    window.show();
  }

  private void fill() {
    cell(0, 0, 960, 560, Gallery::typical, c -> {});
    cell(966, 0, 634, 277, c -> simple(c, "base./odom:linear.x", "base./odom:angular.z"),
        s -> mouse(s, SWT.MouseMove, 250, 120, 0));
    cell(966, 283, 634, 277, Gallery::broken, c -> {});
    cell(0, 566, 500, 200, c -> {}, c -> {});
    cell(506, 566, 454, 200, c -> {
      simple(c, "base./odom:linear.x");
      c.input(PlotType.VALUES).state(new InputState.Stale(4.2, "the link is lost"));
    }, c -> {});
    cell(966, 566, 634, 434,
        c -> simple(c, "arm./joint_states:joints[0].position", "arm./joint_states:joints[1].position",
            "arm./joint_states:joints[2].position"),
        Gallery::choosing);
    cell(0, 772, 500, 228, c -> simple(c, "base./odom:linear.x"), s -> {
      key(s, 'c');
      key(s, 'p');
    });
    cell(506, 772, 454, 228, c -> {
      Robots.candidates(c.input(PlotType.VALUES));
      c.settings().set(PlotOptions.AXES, List.of(Map.of("traces", List.of("base./scan:ranges[3]"))));
    }, c -> {});
  }

  private void fillMore() {
    cell(0, 0, 796, 330, c -> simple(c, "base./odom:linear.x", "base./odom:angular.z"), s -> {
      key(s, 'c');
      mouse(s, SWT.MouseMove, 450, 100, 0);
    });
    cell(802, 0, 798, 330, c -> {
      simple(c);
      c.settings().set(PlotOptions.AXES, List.of(Map.of("traces", List.of("base./odom:linear.x"))));
      FakeInput<Data> lossy = c.input(PlotType.VALUES);
      lossy.drain(e -> {});
      Robots.drive(lossy, 3000);
    }, s -> mouse(s, SWT.MouseMove, 340, 160, 0));
    cell(0, 336, 400, 320, c -> {
      simple(c, "base./sonar:readings[0].range", "arm./joint_states:joints[1].position");
      c.settings().set(PlotOptions.STYLE, "step");
      c.settings().set(PlotOptions.WINDOW, 4.0);
    }, s -> {});
    cell(406, 336, 390, 320, c -> {
      simple(c, "base./sonar:readings[0].range", "arm./joint_states:joints[1].position");
      c.settings().set(PlotOptions.STYLE, "dots");
    }, s -> {});
    cell(802, 336, 798, 320, c -> {
      simple(c, "base./odom:linear.x");
      c.settings().set(PlotOptions.LINKED, false);
      c.settings().set(PlotOptions.AXES, List.of(Map.of("traces", List.of("base./odom:linear.x")),
          Map.of("traces", List.of(Map.of("signal", "base./odom:angular.z", "hidden", true),
              "arm./joint_states:joints[0].velocity"))));
    }, s -> {});
    cell(0, 662, 260, 338, Gallery::typical, s -> {});
    cell(266, 662, 530, 338, c -> {
      simple(c,
          Stream.of("position", "velocity", "effort")
              .flatMap(q -> Stream.of(0, 1, 2).map(i -> "arm./joint_states:joints[" + i + "]." + q))
              .toArray(String[]::new));
      c.settings().set(PlotOptions.LEGEND, "side");
    }, s -> {});
    cell(802, 662, 798, 338, c -> simple(c, "base./odom:linear.x", "scale(base./odom:linear.x, 1, 0.4)"), s -> {
      Event event = new Event();
      event.stateMask = SWT.SHIFT;
      event.button = 1;
      event.x = 150;
      event.y = 60;
      canvas(s).notifyListeners(SWT.MouseDown, event);
      mouse(s, SWT.MouseMove, 380, 200, 1);
    });
  }

  /** Recordings: whole, zoomed, followed, while they are read, failed; and a view without traces. */
  private void fillRecorded() {
    cell(0, 0, 960, 480, c -> recorded(c, "base./odom:linear.x", "base./odom:angular.z",
        "difference(base./odom:linear.x, base./odom:angular.z)"), s -> {
          key(s, 's');
          key(s, 'h');
        });
    cell(966, 0, 634, 300, c -> recorded(c, "base./odom:linear.x", "arm./joint_states:joints[0].position"),
        s -> mouse(s, SWT.MouseMove, 250, 120, 0));
    cell(966, 306, 634, 300, c -> recorded(c, "base./odom:linear.x"), s -> {
      key(s, 'p');
      key(s, 'c');
    });
    cell(0, 486, 500, 240, c -> {
      recorded(c, "base./odom:linear.x");
      c.background(task -> Thread.ofPlatform().daemon().start(() -> {
        try {
          Thread.sleep(1200);
          task.run();
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
        }
      }));
    }, s -> {});
    cell(506, 486, 454, 240, c -> recorded(c, "base./odom:linear.x").fail("run.mcap cannot be read at byte 1048576"),
        s -> {});
    cell(0, 732, 500, 268, c -> recorded(c), s -> {});
    cell(506, 732, 454, 268, c -> recorded(c, "base./odom:linear.x", "base./odom:angular.z"), s -> {
      for (int i = 0; i < 12; i++) {
        key(s, '+');
      }
      key(s, 's');
    });
    cell(966, 612, 634, 388, c -> recorded(c, "base./odom:linear.x").tellEvery(20), s -> {
      Event event = new Event();
      event.stateMask = SWT.SHIFT;
      event.button = 1;
      event.x = 150;
      event.y = 60;
      canvas(s).notifyListeners(SWT.MouseDown, event);
      mouse(s, SWT.MouseMove, 380, 200, 1);
      mouse(s, SWT.MouseUp, 380, 200, 1);
    });
  }

  /** One signal over another: a path with equal scales, of other units, of recordings, without values, wrong. */
  private void fillCurves() {
    cell(0, 0, 796, 480, c -> recordedCurve(c, "base./odom:pose.translation.x", "base./odom:pose.translation.y"),
        s -> mouse(s, SWT.MouseMove, 250, 160, 0));
    cell(802, 0, 798, 480, c -> {
      recorded(c);
      c.settings().set(PlotOptions.AXES, List.of(Map.of("traces", List.of("base./odom:linear.x")), CURVE));
    }, s -> {
      mouse(s, SWT.MouseMove, 250, 80, 0);
      key(s, 'c');
    });
    cell(0, 486, 500, 514, c -> {
      simple(c);
      c.settings().set(PlotOptions.AXES, List.of(CURVE));
    }, s -> {});
    cell(506, 486, 454, 300, c -> {
      simple(c);
      c.settings().set(PlotOptions.STYLE, "dots");
      c.settings().set(PlotOptions.AXES, List.of(Map.of("x", "base./odom:linear.x", "traces",
          List.of("base./odom:angular.z", "derivative(base./odom:linear.x)"))));
    }, s -> {});
    cell(506, 792, 454, 208, c -> {
      simple(c);
      c.settings().set(PlotOptions.AXES,
          List.of(Map.of("x", "base./odom:pose.east", "traces", List.of("base./odom:linear.x"))));
    }, s -> {});
    cell(966, 486, 634, 514, c -> recordedCurve(c, "base./odom:pose.translation.x", "base./odom:pose.translation.y"),
        s -> {
          for (int i = 0; i < 8; i++) {
            key(s, '+');
          }
          key(s, 's');
        });
  }

  private static final Map<String, Object> CURVE =
      Map.of("x", "base./odom:pose.translation.x", "traces", List.of("base./odom:pose.translation.y"));

  private static void recordedCurve(FakeUicContext context, String x, String y) {
    recorded(context);
    context.settings().set(PlotOptions.AXES, List.of(Map.of("x", x, "traces", List.of(y))));
  }

  private static KeptHistory recorded(FakeUicContext context, String... signals) {
    FakeInput<Data> input = context.input(PlotType.VALUES);
    Robots.candidates(input);
    KeptTimeline timeline = new KeptTimeline();
    timeline.seek(KeptHistory.BEGIN + 140 * KeptHistory.SECOND);
    KeptHistory history = Robots.run(new KeptHistory(timeline));
    input.history(Robots.ODOM, history);
    input.history(Robots.JOINTS, history);
    context.settings().set(PlotOptions.TIME, PlotOptions.BY_STAMP);
    context.settings().set(PlotOptions.AXES,
        signals.length == 0 ? List.of() : List.of(Map.of("traces", List.of(signals))));
    return history;
  }

  private static void typical(FakeUicContext context) {
    Map<String, Object> smooth = new LinkedHashMap<>();
    smooth.put("source", "base./odom");
    smooth.put("path", "linear.x");
    smooth.put("derive", List.of("average(0.5)", "derivative"));
    smooth.put("scale", "right");
    Robots.drive(context.input(PlotType.VALUES));
    context.settings().set(PlotOptions.AXES, List.of(
        Map.of("traces",
            List.of("base./odom:linear.x", "base./odom:angular.z",
                "difference(base./odom:linear.x, base./odom:angular.z)")),
        Map.of("traces", List.of("base./sonar:readings[0].range", smooth), "range", List.of(0L, 4L)),
        Map.of("traces", List.of("arm./joint_states:joints[0].position", "arm./joint_states:joints[1].position"))));
  }

  private static void simple(FakeUicContext context, String... signals) {
    Robots.drive(context.input(PlotType.VALUES));
    context.settings().set(PlotOptions.AXES, List.of(Map.of("traces", List.of(signals))));
    context.settings().set(PlotOptions.WINDOW, 20.0);
  }

  private static void broken(FakeUicContext context) {
    simple(context, "base./odom:linear.x", "base./odom:twist.speed", "base./imu:angular.z",
        "sine(base./odom:linear.x)");
  }

  private static void choosing(Composite part) {
    Control[] inside = ((Composite) part.getChildren()[0]).getChildren();
    key(part, 'a');
    part.layout(true, true);
    Control list = ((Composite) inside[1]).getChildren()[2];
    for (int code : new int[]{SWT.HOME, SWT.ARROW_RIGHT, SWT.ARROW_DOWN, SWT.ARROW_DOWN}) {
      Event event = new Event();
      event.keyCode = code;
      list.notifyListeners(SWT.KeyDown, event);
    }
  }

  private static Control canvas(Composite part) {
    return ((Composite) part.getChildren()[0]).getChildren()[0];
  }

  private static void mouse(Composite part, int type, int x, int y, int button) {
    Event event = new Event();
    event.x = x;
    event.y = y;
    event.button = button;
    canvas(part).notifyListeners(type, event);
  }

  private static void key(Composite part, int code) {
    Event event = new Event();
    event.keyCode = code;
    canvas(part).notifyListeners(SWT.KeyDown, event);
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare, Consumer<Composite> act) {
    FakeUicContext context = new FakeUicContext("plot", new PlotType().schema());
    context.settings().set(PlotOptions.TIME, PlotOptions.BY_RECEIPT);
    prepare.accept(context);
    Composite part = window.cell(x, y, width, height);
    PlotUic uic = new PlotUic(context);
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
    step(uic);
    Display.getCurrent().timerExec(500, () -> {
      act.accept(part);
      step(uic);
      if (context.input(PlotType.VALUES).state() instanceof InputState.Stale) {
        return;
      }
      context.input(PlotType.VALUES).put(Robots.JOINTS, Robots.joints(0.4), System.nanoTime(), Optional.empty());
      context.input(PlotType.VALUES).put(Robots.ODOM, Robots.odometry(0.31, 0.2), System.nanoTime(), Optional.empty());
      step(uic);
    });
    Display.getCurrent().timerExec(1500, () -> step(uic));
  }

  private static void step(PlotUic uic) {
    uic.tick(System.nanoTime());
    uic.refresh();
  }
}
