package org.robotui.uic.jointcontrol.internal;

import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.config.SettingsStore;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.uic.jointcontrol.internal.model.ControlModel;
import org.robotui.uic.jointcontrol.internal.model.JointDriver;
import org.robotui.uic.jointcontrol.internal.view.JointsSurface;
import org.robotui.uic.jointcontrol.internal.view.Wishes;

/** The view: the tick takes what came and sends what is due, the surface lists. */
final class JointControlUic extends SurfaceUic<JointsSurface> implements Wishes {
  private static final double HUNDREDTHS = 100;

  private final SettingsStore settings;
  private final JointDriver driver;
  private final ControlModel model;

  JointControlUic(UicContext context) {
    settings = context.settings();
    driver = new JointDriver(context.output(JointControlPorts.COMMAND), context.principal(), this::speed);
    model = new ControlModel(context.input(JointControlPorts.CONTROL), context.input(JointControlPorts.MODEL), driver,
        this::degrees);
    offers().add("drive", "Drive joints", Icon.STEER, () -> model.look().drive().driving(), this::drive);
  }

  @Override
  public boolean tick(long nowNanos) {
    boolean changed = model.tick(nowNanos);
    surface().ifPresent(JointsSurface::prepare);
    return changed;
  }

  @Override
  protected JointsSurface open(Composite parent, UiContext ui) {
    return new JointsSurface(parent, ui, model, driver, this);
  }

  @Override
  protected void refresh(JointsSurface shown) {
    shown.refresh();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("Left, right", "Move the joint by a fine step"),
        new ViewKey("Shift+Left, right", "Move it by ten steps"),
        new ViewKey("Digits, Enter", "Type a target"),
        new ViewKey("Space", "Stop the robot"),
        new ViewKey("Esc", "End driving, and release control"),
        new ViewKey("Ctrl+F, /", "Filter"));
  }

  @Override
  public void close() {
    driver.end("The view was closed");
  }

  @Override
  public boolean degrees() {
    return settings.current().flag(JointControlType.DEGREES);
  }

  @Override
  public void degrees(boolean wanted) {
    settings.set(JointControlType.DEGREES, wanted);
    surface().ifPresent(JointsSurface::again);
  }

  @Override
  public double speed() {
    return settings.current().number(JointControlType.SPEED);
  }

  @Override
  public void speed(double share) {
    settings.set(JointControlType.SPEED, Math.max(1, Math.round(share * HUNDREDTHS)) / HUNDREDTHS);
    surface().ifPresent(JointsSurface::again);
  }

  JointDriver driver() {
    return driver;
  }

  /** Selects a line of the table by its key. */
  void select(String key) {
    surface().ifPresent(made -> made.select(key));
  }

  private void drive() {
    driver.toggle();
    surface().ifPresent(JointsSurface::again);
  }
}
