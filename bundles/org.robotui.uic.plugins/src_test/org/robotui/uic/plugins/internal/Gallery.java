package org.robotui.uic.plugins.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.InputState;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.api.port.PluginRequest.Verb;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.Drives.Phase;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeCaller;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in its states side by side, for a person to look at: {@code Gallery dark|light [page]}. */
final class Gallery {
  private final GalleryWindow window;
  private final Theme theme;
  private FakeCaller<PluginRequest, PluginReply> caller = new FakeCaller<>();

  private Gallery(GalleryWindow window, Theme theme) {
    this.window = window;
    this.theme = theme;
  }

  public static void main(String[] arguments) {
    Display display = new Display();
    Theme theme = Themes.of(display, arguments[0]);
    GalleryWindow window = new GalleryWindow(display, theme.color(Role.LINE));
    Gallery gallery = new Gallery(window, theme);
    switch (arguments.length > 1 ? arguments[1] : "1") {
      case "1" -> gallery.first();
      case "2" -> gallery.second();
      default -> gallery.third();
    }
    window.show();
  }

  private void first() {
    cell(0, 0, 1600, 494, "plugin gravity", (c, u) -> Controls.put(c, Controls.arm(), Controls.timing(true)));
    cell(0, 500, 560, 500, "plugin cartesian", (c, u) -> Controls.put(c, Controls.arm(), Controls.timing(false)));
    cell(566, 500, 1034, 500, "loop motion/slow", (c, u) -> {
      Controls.put(c, Controls.arm(), Controls.timing(true));
      c.authority().take(FakeAuthority.ANNA, true);
      u.model().verbs().ask("sine", Verb.START, "");
    });
  }

  private void second() {
    cell(0, 0, 796, 540, "plugin sine", (c, u) -> {
      Controls.put(c, Controls.arm(), Controls.timing(true));
      u.tick(0);
      u.model().verbs().ask("sine", Verb.START, "");
      answer(u, new PluginReply(false, "sine needs arm_1, which homing owns; stop homing first"));
    });
    cell(802, 0, 798, 540, "plugin homing", (c, u) -> {
      Controls.put(c, Controls.arm(), Controls.timing(true));
      u.model().verbs().ask("homing", Verb.COMMAND, "speed 0.4");
      answer(u, new PluginReply(true, "speed is 0.4"));
    });
    cell(0, 546, 396, 454, "plugin gravity", (c, u) -> Controls.put(c, Controls.arm(), Controls.timing(true)));
    cell(402, 546, 394, 224, "", (c, u) -> {});
    cell(802, 546, 394, 224, "", (c, u) -> {
      Controls.put(c, Controls.arm(), Controls.timing(true));
      c.input(PluginsPorts.PLUGINS).state(new InputState.Stale(3.4, "silent"));
    });
    cell(1202, 546, 398, 224, "", (c, u) -> c.input(PluginsPorts.PLUGINS).put(Controls.PLUGINS,
        new ControlPlugins(List.of()), 0, Optional.empty()));
    cell(402, 776, 394, 224, "", (c, u) -> c.input(PluginsPorts.PLUGINS)
        .state(new InputState.Failed("the control speaks version 9, this is version 4")));
    cell(802, 776, 798, 224, "plugin homing",
        (c, u) -> c.input(PluginsPorts.PLUGINS).put(Controls.PLUGINS, Controls.arm(), 0, Optional.empty()));
  }

  private void third() {
    cell(0, 0, 564, 640, "plugin gravity", (c, u) -> Controls.put(c, Controls.arm(), Controls.timing(true)));
    cell(570, 0, 564, 640, "plugin cartesian", (c, u) -> Controls.put(c, Controls.arm(), Controls.timing(true)));
    cell(1140, 0, 436, 640, "loop motion/slow", (c, u) -> Controls.put(c, Controls.arm(), Controls.timing(false)));
    cell(1096, 646, 480, 354, "drives", (c, u) -> {
      Controls.put(c, Controls.arm(), Controls.timing(true));
      c.input(PluginsPorts.DRIVES).put(Controls.DRIVES, Controls.drives(Phase.FAULT, Phase.ENABLED, Phase.DISABLED), 0,
          Optional.empty());
    });
    cell(0, 646, 1090, 354, "plugin logging", (c, u) -> {
      Controls.put(c, Controls.arm(), Controls.timing(true));
      c.input(PluginsPorts.PLUGINS).state(new InputState.Stale(3.4, "silent"));
    });
  }

  private void answer(PluginsUic uic, PluginReply reply) {
    caller.made().getLast().end().complete(new CallOutcome.Replied<>(reply));
    uic.tick(0);
  }

  private void cell(int x, int y, int width, int height, String selected,
      BiConsumer<FakeUicContext, PluginsUic> prepare) {
    FakeUicContext context = new FakeUicContext("plugins", new PluginsType().schema());
    caller = new FakeCaller<>(Controls.VERBS);
    context.caller(PluginsPorts.VERBS, caller);
    Composite part = window.cell(x, y, width, height);
    PluginsUic uic = new PluginsUic(context);
    prepare.accept(context, uic);
    uic.tick(System.nanoTime());
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
    uic.select(selected);
  }
}
