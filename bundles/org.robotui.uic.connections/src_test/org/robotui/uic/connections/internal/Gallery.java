package org.robotui.uic.connections.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.host.RuicView;
import org.robotui.api.link.LinkState;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeRuicView;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.connections.internal.model.Robots;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 980, 620, Select.of("Keira\nSTREAM camera.image"), robots());
    cell(986, 0, 614, 300, Select.NONE, robots(), c -> c.settings().set(ConnectionsType.PROBLEMS, true));
    cell(986, 306, 614, 314, Select.of("Keira\nSTREAM base./diagnostics"), robots(),
        c -> c.settings().set(ConnectionsType.ROBOT, "Keira"));
    cell(0, 626, 420, 374, Select.of("Natalie\nbase"), List.of(Robots.plain("Natalie", Robots.DOWN), Robots.keira()));
    cell(426, 626, 380, 180, Select.NONE, List.of());
    cell(812, 626, 380, 180, Select.NONE, List.of(Robots.plain("Keira", Robots.UP)),
        c -> c.settings().set(ConnectionsType.PROBLEMS, true));
    cell(1198, 626, 402, 374, Select.NONE,
        IntStream.range(0, 50).mapToObj(i -> Robots.large("robot" + i, 50)).toList());
    cell(426, 812, 766, 188, Select.NONE,
        List.of(new RuicSnapshot("Keira", RuicState.FAILED, "the type 'ros' is not installed", Robots.UP,
            List.of(), List.of(), List.of()), Robots.plain("Natalie", new LinkState.Connecting("10.0.0.7:11311"))));
  }

  private static List<RuicSnapshot> robots() {
    return List.of(Robots.keira(), Robots.plain("Natalie", Robots.DOWN),
        Robots.plain("Otto",
            new LinkState.Degraded("otto:11311", "/scan has the type foo/Scan, expected sensor_msgs/LaserScan")));
  }

  private record Select(Optional<String> key) {
    static final Select NONE = new Select(Optional.empty());

    static Select of(String key) {
      return new Select(Optional.of(key));
    }
  }

  private void cell(int x, int y, int width, int height, Select select, List<RuicSnapshot> robots) {
    cell(x, y, width, height, select, robots, c -> {});
  }

  private void cell(int x, int y, int width, int height, Select select, List<RuicSnapshot> robots,
      Consumer<FakeUicContext> prepare) {
    FakeUicContext context = new FakeUicContext("connections", new ConnectionsType(FakeBridges.NONE).schema());
    context.ruics(robots.stream().map(Gallery::view).toList());
    prepare.accept(context);
    Composite part = window.cell(x, y, width, height);
    ConnectionsUic uic = new ConnectionsUic(context, List::of);
    uic.tick(0);
    uic.tick(190_000_000_000L);
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
    select.key().ifPresent(uic::select);
  }

  private static RuicView view(RuicSnapshot snapshot) {
    FakeRuicView view = new FakeRuicView(new FakeAuthority(snapshot.name()));
    view.snapshot(snapshot);
    return view;
  }
}
