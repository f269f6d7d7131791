package org.robotui.tests.badwindow;

import java.util.List;
import java.util.Locale;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;

/**
 * The type of a view that misbehaves once in {@code createControl}, {@code refresh}, {@code paint}, {@code actions} or
 * {@code key}.
 */
final class BadView implements UicType {
  private static final double RATE_HZ = 20;
  private static final Schema SCHEMA = Schema.of(
      Setting.of("in", new ValueType.Text(), "nowhere", "In which method."),
      Setting.of("does", new ValueType.Text(), "nothing", "What."),
      Setting.of("once", new ValueType.Text(), "",
          "The system property whose being set it waits for; it does not wait when empty."));

  @Override
  public Descriptor descriptor() {
    return new Descriptor("badwindow", "Bad view", "A view of the tests.", SCHEMA, List.of());
  }

  @Override
  public Surface surface() {
    return Surface.WINDOW;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new Instance(settings.text("in"), Misdeed.valueOf(settings.text("does").toUpperCase(Locale.ROOT)),
        settings.text("once"));
  }

  /** Display thread only, but for ticks. */
  private static final class Instance implements SwtUic {
    private final String where;
    private final Misdeed misdeed;
    private final String gate;
    private boolean done;
    private Canvas canvas;

    Instance(String where, Misdeed misdeed, String gate) {
      this.where = where;
      this.misdeed = misdeed;
      this.gate = gate;
    }

    private void at(String place) {
      if (!done && place.equals(where) && (gate.isEmpty() || Boolean.getBoolean(gate))) {
        done = true;
        misdeed.commit();
      }
    }

    @Override
    public Control createControl(Composite parent, UiContext context) {
      canvas = new Canvas(parent, SWT.NONE);
      canvas.addListener(SWT.Paint, e -> at("paint"));
      canvas.addListener(SWT.KeyDown, e -> at("key"));
      at("createControl");
      return canvas;
    }

    @Override
    public void refresh() {
      at("refresh");
      canvas.redraw();
    }

    @Override
    public List<ViewAction> actions() {
      at("actions");
      return List.of();
    }

    @Override
    public boolean tick(long nowNanos) {
      return true;
    }

    @Override
    public void close() {
      // It holds nothing.
    }
  }
}
