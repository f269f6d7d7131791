package org.robotui.workbench.internal.dock;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.robotui.api.host.RuicState;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.Layout;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/** A surface with three painted views in a window of 800 by 600, driven by events. */
abstract class SurfaceBench {
  static final Layout ROW = new Layout.Split(Layout.Direction.ROW,
      List.of(new Layout.Tabs(List.of("map", "plot")), new Layout.View("camera")), List.of(1.0, 1.0));

  final PaintedView map = new PaintedView("follow");
  final PaintedView camera = new PaintedView("30 Hz");
  final PaintedView plot = new PaintedView("");
  final FakeRuic ruic = new FakeRuic("Keira").in(RuicState.SELECTED, "").view("map", map)
      .view("camera", camera).view("plot", plot);
  final ArrangeHistory history = new ArrangeHistory();
  final List<String> asked = new ArrayList<>();
  Theme theme;
  Shell shell;

  @BeforeEach
  void open() {
    theme = Themes.dark(TestDisplay.get());
    shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 800, 600);
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  RuicSurface show(Layout layout) {
    ruic.laidOut(layout);
    RuicSurface surface = new RuicSurface(shell, theme, ruic, history, () -> asked.add("add"));
    shell.open();
    shell.layout(true, true);
    return surface;
  }

  Arrangement now() {
    return ruic.arranging().now();
  }

  static <C extends Control> C find(Composite above, Class<C> type) {
    return Controls.all(above, type).getFirst();
  }

  static TitleLine line(String view) {
    return Arrays.stream(TestDisplay.get().getShells()).flatMap(s -> Controls.all(s, ViewStack.class).stream())
        .filter(stack -> stack.ids().contains(view)).findFirst().orElseThrow().line();
  }

  static Control stack(PaintedView view) {
    Control at = view.control;
    while (!(at instanceof ViewStack)) {
      at = at.getParent();
    }
    return at;
  }

  static void send(Control control, int type, int x, int y, int state, int button) {
    Event event = new Event();
    event.x = x;
    event.y = y;
    event.stateMask = state;
    event.button = button;
    event.count = 1;
    control.notifyListeners(type, event);
  }
}
