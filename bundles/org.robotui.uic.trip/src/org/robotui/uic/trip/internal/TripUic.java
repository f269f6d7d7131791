package org.robotui.uic.trip.internal;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.UicContext;
import org.robotui.api.port.Input;
import org.robotui.data.navigation.Odometry;
import org.robotui.ui.Icon;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;

/** The view. The tick runs on a worker and prepares what the canvas paints on the display thread. */
final class TripUic implements SwtUic {

  private final UicContext context;
  private final Input<Odometry> odometry;
  private final TripMeter meter = new TripMeter(); // only on the thread of the tick
  private final AtomicBoolean resetWanted = new AtomicBoolean();
  private final List<ViewAction> actions;
  private volatile TripViewState state;
  private Optional<TripCanvas> canvas = Optional.empty(); // only on the display thread

  TripUic(UicContext context) {
    this.context = context;
    this.odometry = context.input(TripType.ODOMETRY);
    this.actions = List.of(
        new ViewAction("reset", "Begin a new trip", Icon.RESTART.id(), Optional.empty(), () -> resetWanted.set(true)));
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
  public Control createControl(Composite parent, UiContext ui) {
    TripCanvas made = new TripCanvas(parent, ui.theme(), this::state);
    canvas = Optional.of(made);
    return made.control();
  }

  @Override
  public void refresh() {
    canvas.ifPresent(TripCanvas::refresh);
  }

  @Override
  public List<ViewAction> actions() {
    return actions;
  }

  @Override
  public void close() {
    // Nothing is held but memory.
  }
}
