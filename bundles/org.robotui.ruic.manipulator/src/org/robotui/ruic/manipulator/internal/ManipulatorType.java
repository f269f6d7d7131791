package org.robotui.ruic.manipulator.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.FixedRuicType;
import org.robotui.api.RuicType;
import org.robotui.api.layout.Layout.Direction;
import org.robotui.api.layout.Layout.Split;
import org.robotui.api.layout.Layout.Tabs;
import org.robotui.api.layout.Layout;

/**
 * The interface of a robot with joints under real-time control, an arm or a humanoid: the joints, and below them the
 * robot in space as it moves, have most of the window; behind the picture lies what it measures and says. Beside them
 * are the plugins that drive the joints and how well they keep their time. The text view is for terminals, the sound
 * view for ears; both have no place in the window's layout.
 */
@Component(service = RuicType.class)
public final class ManipulatorType extends FixedRuicType {
  private static final Tabs JOINTS = new Tabs(List.of("jointcontrol", "postures", "tftree"));
  private static final Tabs PICTURE = new Tabs(List.of("scene3d", "plot", "log", "alerts"));
  private static final Tabs PLUGINS = new Tabs(List.of("plugins"));
  private static final Tabs STATE = new Tabs(List.of("status", "connections"));

  private static final Layout MAIN = new Split(Direction.COLUMN, List.of(JOINTS, PICTURE), List.of(46.0, 54.0));

  private static final Layout SIDE = new Split(Direction.COLUMN, List.of(PLUGINS, STATE), List.of(72.0, 28.0));

  private static final Layout LAYOUT = new Split(Direction.ROW, List.of(MAIN, SIDE), List.of(60.0, 40.0));

  /** Made by the framework. */
  public ManipulatorType() {
    super("manipulator", "Manipulator",
        "Joints and control plugins of an arm or a humanoid, with loop timing, plots, log and status.",
        LAYOUT, "sound", "text");
  }
}
