package org.robotui.uic.postures.internal;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.data.control.ControlPlugins.State;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeCaller;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in its states side by side, for a person to look at: {@code Gallery dark|light}. */
final class Gallery {
  private static final long SECOND = 1_000_000_000L;

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
    new Gallery(window, theme).fill();
    window.show();
  }

  private void fill() {
    cell(0, 0, 700, 320, false, (arm, uic) -> arm.context().settings().set("postures", List.of()));
    cell(706, 0, 894, 320, true, (arm, uic) -> {
      arm.now().at(0.3, -0.8);
      uic.tick(0);
    });
    cell(0, 326, 700, 320, true, (arm, uic) -> {
      uic.model().play(0);
      arm.answer();
      arm.now().at(0.55, -0.3).plugin(State.RUNNING, "moving");
    });
    cell(706, 326, 894, 320, true, (arm, uic) -> {
      uic.model().goTo(2);
      arm.answer();
      uic.tick(0);
      arm.now().plugin(State.RUNNING,
          "refused: on the way to point 1 elbow would need 1.4 times its velocity limit: give it more time");
    });
    cell(0, 652, 700, 348, true, (arm, uic) -> {
      arm.context().authority().take(FakeAuthority.ANNA, true);
      uic.model().play(0);
    });
    cell(706, 652, 440, 348, true, (arm, uic) -> {
      arm.now().plugins(State.STOPPED, "holding", State.RUNNING);
      arm.context().settings().set("loop", true);
      uic.model().guide(true);
    });
    cell(1152, 652, 448, 170, true,
        (arm, uic) -> arm.context().input(PosturesPorts.CONTROL).state(new InputState.Stale(4.2, "silent")));
    cell(1152, 828, 448, 172, true, (arm, uic) -> arm.context().authority().stop(FakeAuthority.YOU));
  }

  /** A robot beside a view. */
  private record Arm(FakeUicContext context, ArmNow now, FakeCaller<PluginRequest, PluginReply> caller) {
    void answer() {
      for (int i = 0; i < caller.made().size(); i++) {
        CompletableFuture<CallOutcome<PluginReply>> end = caller.made().get(i).end();
        end.complete(new CallOutcome.Replied<>(new PluginReply(true, "")));
      }
    }
  }

  private void cell(int x, int y, int width, int height, boolean full, BiConsumer<Arm, PosturesUic> prepare) {
    FakeUicContext context = new FakeUicContext("postures", new PosturesType().schema());
    FakeCaller<PluginRequest, PluginReply> caller = new FakeCaller<>(ArmNow.VERBS);
    context.caller(PosturesPorts.VERBS, caller);
    if (full) {
      context.settings().set("postures", List.of(posture("Home", 3, 0, 0), posture("Above the table", 2, 0.6, -0.4),
          posture("At the table", 1.5, 0.9, -0.8), posture("Hand over", 2.5, -0.7, 0.5)));
    }
    ArmNow now = new ArmNow(context).at(0.6, -0.4).plugin(State.RUNNING, "holding");
    Composite part = window.cell(x, y, width, height);
    PosturesUic uic = new PosturesUic(context);
    uic.tick(0);
    prepare.accept(new Arm(context, now, caller), uic);
    uic.tick(2 * SECOND);
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
    uic.select(1);
  }

  private static Map<String, Object> posture(String name, double seconds, double shoulder, double elbow) {
    Map<String, Object> joints = new LinkedHashMap<>();
    joints.put("shoulder", shoulder);
    joints.put("elbow", elbow);
    return Map.of("name", name, "seconds", seconds, "joints", joints);
  }
}
