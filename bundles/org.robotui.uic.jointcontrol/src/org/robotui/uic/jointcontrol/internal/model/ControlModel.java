package org.robotui.uic.jointcontrol.internal.model;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.data.joint.JointControl;
import org.robotui.data.joint.JointModel;
import org.robotui.ui.StateView;

/** Takes what came, lets the driver send, and says what is to be shown. Ticked by one thread; the look is for all. */
public final class ControlModel {
  private final Input<JointControl> control;
  private final Input<JointModel> model;
  private final JointDriver driver;
  private final BooleanSupplier degrees;
  private Joints joints = Joints.NONE;
  private Optional<JointControl> seen = Optional.empty();
  private Optional<JointModel> described = Optional.empty();
  private volatile ControlLook look;

  /** With the inputs, the driver and the user's wish for degrees. */
  public ControlModel(Input<JointControl> control, Input<JointModel> model, JointDriver driver,
      BooleanSupplier degrees) {
    this.control = control;
    this.model = model;
    this.driver = driver;
    this.degrees = degrees;
    this.look = now();
  }

  /** Takes and sends what is due; whether anything is new. */
  public boolean tick(long nowNanos) {
    take();
    driver.see(joints, control.state());
    driver.tick(nowNanos);
    ControlLook next = now();
    boolean changed = !next.equals(look);
    look = next;
    // While the user drives the surface watches the focus at every refresh.
    return changed || next.drive().driving();
  }

  /** What is to be shown now. */
  public ControlLook look() {
    return look;
  }

  /** The same after the user has done something, without waiting for the next tick. */
  public ControlLook fresh() {
    ControlLook last = look;
    ControlLook next = new ControlLook(last.state(), last.joints(), driver.look(), degrees.getAsBoolean());
    look = next;
    return next;
  }

  private ControlLook now() {
    return new ControlLook(control.state(), joints, driver.look(), degrees.getAsBoolean());
  }

  private void take() {
    InputState state = control.state();
    Optional<JointControl> newest = control.latest().map(Envelope::value);
    Optional<JointModel> told = model.latest().map(Envelope::value);
    if (!StateView.showsContent(state)) {
      joints = Joints.NONE;
      seen = Optional.empty();
    } else if (newest.isPresent() && !(newest.equals(seen) && told.equals(described))) {
      joints = Joints.of(told, newest.get());
      seen = newest;
      described = told;
    }
  }
}
