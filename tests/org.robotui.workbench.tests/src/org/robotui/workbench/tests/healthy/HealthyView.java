package org.robotui.workbench.tests.healthy;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Settings;
import org.robotui.ui.Role;
import org.robotui.ui.SwtUic;
import org.robotui.ui.UiContext;

/**
 * A type of view that works, in a package of its own: the tests are on the stack of all that happens on the display
 * thread, and whose package is on the stack of a failure is blamed. It remembers the controls of its instances.
 *
 * @param controls all controls ever made, in order
 */
public record HealthyView(List<Control> controls) implements UicType {
  /** Without controls. */
  public HealthyView() {
    this(new CopyOnWriteArrayList<>());
  }

  @Override
  public Descriptor descriptor() {
    return new Descriptor("healthy", "Healthy", "A view of the tests.", Schema.EMPTY, List.of());
  }

  @Override
  public Surface surface() {
    return Surface.WINDOW;
  }

  @Override
  public double rateHz() {
    return 20;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new Instance();
  }

  /** Always has something new. */
  private final class Instance implements SwtUic {
    @Override
    public Control createControl(Composite parent, UiContext context) {
      Canvas canvas = new Canvas(parent, SWT.NONE);
      canvas.setBackground(context.theme().color(Role.ACCENT));
      controls.add(canvas);
      return canvas;
    }

    @Override
    public void refresh() {
      controls.getLast().redraw();
    }

    @Override
    public boolean tick(long nowNanos) {
      return true;
    }

    @Override
    public void close() {}
  }
}
