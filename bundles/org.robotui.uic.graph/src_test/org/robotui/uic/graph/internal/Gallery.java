package org.robotui.uic.graph.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.graph.internal.model.Ask;
import org.robotui.uic.graph.internal.model.Robots;
import org.robotui.uic.graph.internal.model.Vertex;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    Vertex scan = new Vertex(Vertex.Kind.TOPIC, "base", "/scan");
    cell(0, 0, 1100, 480, Optional.of(Robots.base()), ask -> ask);
    cell(1106, 0, 494, 480, Optional.of(Robots.base()), ask -> ask.search("detector"));
    cell(0, 486, 800, 514, Optional.of(Robots.base()),
        ask -> ask.show(false, true, true, true, true).select(Optional.of(
            new Vertex(Vertex.Kind.NODE, "base", "/move_base"))));
    cell(806, 486, 400, 250, Optional.of(Robots.many(200, 2000)), ask -> ask);
    cell(1212, 486, 388, 250, Optional.empty(), ask -> ask);
    cell(806, 742, 400, 258, Optional.of(Robots.base()), ask -> ask.select(Optional.of(scan)).measure(true));
    cell(1212, 742, 388, 258, Optional.of(Robots.base()), ask -> ask.search("nonsense"));
  }

  private void cell(int x, int y, int width, int height, Optional<Robots> robot, UnaryOperator<Ask> wanted) {
    FakeUicContext context = new FakeUicContext("graph", GraphOptions.schema());
    robot.ifPresent(r -> context.robots(List.of(r.robot("base"))));
    Composite part = window.cell(x, y, width, height);
    GraphUic uic = new GraphUic(context);
    part.addListener(SWT.Dispose, e -> uic.close());
    uic.ask(wanted.apply(uic.asked()));
    uic.createControl(part, UiContext.of(theme, part::setData));
    uic.seen();
    for (int i = 0; i < 3; i++) {
      uic.tick(System.nanoTime());
    }
    uic.refresh();
    part.layout(true, true);
  }
}
