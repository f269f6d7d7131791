package org.robotui.uic.trip.internal;

import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.port.Input;
import org.robotui.data.navigation.Odometry;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;

/** The view. The tick runs on a worker and prepares what the canvas paints on the display thread. */
final class TripUic extends SurfaceUic<TripCanvas> {

  private final UicContext context;
  private final Input<Odometry> odometry;
  private final TripMeter meter = new TripMeter(); // only on the thread of the tick
  private final AtomicBoolean resetWanted = new AtomicBoolean();
  private volatile TripViewState state;

  TripUic(UicContext context) {
    this.context = context;
    this.odometry = context.input(TripType.ODOMETRY);
    offers().add("reset", "Begin a new trip", Icon.RESTART, () -> resetWanted.set(true));
    this.state = look();
  }

  @Override
  public boolean tick(long nowNanos) {
    if (resetWanted.getAndSet(false)) {
      meter.reset();
    }
    odometry.drain(envelope -> meter.add(envelope.source(), envelope.value().pose().translation()));
    TripViewState before = state;
    state = look();
    return !state.equals(before);
  }

  private TripViewState look() {
    return new TripViewState(odometry.state(), meter.trips(), context.settings().current().number(TripType.LIMIT));
  }

  TripViewState state() {
    return state;
  }

  @Override
  protected TripCanvas open(Composite parent, UiContext ui) {
    return new TripCanvas(parent, ui.theme(), this::state);
  }

  @Override
  protected void refresh(TripCanvas shown) {
    shown.refresh();
  }
}
