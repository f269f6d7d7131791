package org.robotui.workbench.internal.dock;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Sash;
import org.robotui.api.layout.Layout;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/** The views of one window as a layout has them: sashes, and between them stacks of views. Display thread only. */
final class DockTree extends Composite {
  private static final int SASH = 4;
  private static final double UNITS = 1000;
  /** A sash is moved in many steps, and is let go once. */
  private static final int SETTLED_MILLIS = 300;

  /** Gives the tree its stacks, and is told what the user does with sashes. */
  interface Builder {
    /** Makes a stack of views. */
    ViewStack stack(DockTree parent, Composite within, List<String> views, int front);

    /** What stands where there is no view. */
    void empty(Composite within);

    /** The user has divided a split. */
    void divided(DockTree tree, List<Integer> place, List<Double> weights);
  }

  private final Theme theme;
  private final Builder builder;
  private final DropFrame frame;
  private final List<ViewStack> stacks = new ArrayList<>();
  private final Map<List<Integer>, SashForm> forms = new HashMap<>();
  private Layout shown = new Layout.Tabs(List.of());
  private Optional<ViewStack> maximized = Optional.empty();
  private boolean locked;

  DockTree(Composite parent, Theme theme, Builder builder) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.builder = builder;
    setBackground(theme.color(Role.PANEL));
    setLayout(new Whole());
    frame = new DropFrame(this, theme);
  }

  List<ViewStack> stacks() {
    return List.copyOf(stacks);
  }

  DropFrame frame() {
    return frame;
  }

  /** Whether showing a layout makes all stacks anew: views have to be elsewhere then. */
  boolean wantsNewStacks(Layout layout) {
    return !plain(layout).equals(plain(shown)) || content().isEmpty();
  }

  /** Shows a layout. */
  void show(Layout layout) {
    if (wantsNewStacks(layout)) {
      clear();
      build(this, layout, List.of());
      layout(true, true);
    } else {
      update(layout, List.of());
    }
    shown = layout;
  }

  private void clear() {
    maximized = Optional.empty();
    stacks.clear();
    forms.clear();
    content().ifPresent(Control::dispose);
  }

  private Optional<Control> content() {
    return Stream.of(getChildren()).filter(child -> !(child instanceof Aside)).findFirst();
  }

  /** What decides about the controls. */
  private static Layout plain(Layout layout) {
    return switch (layout) {
      case Layout.View view -> new Layout.Tabs(List.of(view.uic()));
      case Layout.Tabs tabs -> new Layout.Tabs(tabs.uics());
      case Layout.Split split -> new Layout.Split(split.direction(),
          split.parts().stream().map(DockTree::plain).toList(), split.parts().stream().map(p -> 1.0).toList());
    };
  }

  private void build(Composite parent, Layout layout, List<Integer> place) {
    switch (layout) {
      case Layout.Split split -> split(parent, split, place);
      case Layout.Tabs tabs when tabs.uics().isEmpty() -> builder.empty(parent);
      case Layout.Tabs tabs -> stacks.add(builder.stack(this, parent, tabs.uics(), tabs.front()));
      case Layout.View view -> stacks.add(builder.stack(this, parent, List.of(view.uic()), 0));
    }
  }

  private void split(Composite parent, Layout.Split split, List<Integer> place) {
    SashForm form = new Splitter(parent, split.direction());
    form.setBackground(theme.mix(Role.LINE, Role.GROUND, 0.6));
    form.setSashWidth(SASH);
    for (int i = 0; i < split.parts().size(); i++) {
      build(form, split.parts().get(i), within(place, i));
    }
    form.setWeights(weights(split));
    forms.put(place, form);
    follow(form, place);
  }

  /** Not a plain sash form, which style sheets would colour. */
  private static final class Splitter extends SashForm {
    Splitter(Composite parent, Layout.Direction direction) {
      super(parent, (direction == Layout.Direction.ROW ? SWT.HORIZONTAL : SWT.VERTICAL) | SWT.SMOOTH);
    }
  }

  /** The sashes are made when the form is laid out for the first time. */
  private void follow(SashForm form, List<Integer> place) {
    Set<Control> followed = new HashSet<>();
    Runnable settled = () -> {
      if (!form.isDisposed()) {
        builder.divided(this, place, Arrays.stream(form.getWeights()).asDoubleStream().boxed().toList());
      }
    };
    form.addListener(SWT.Resize, e -> getDisplay().asyncExec(() -> {
      if (!form.isDisposed()) {
        Stream.of(form.getChildren()).filter(Sash.class::isInstance).filter(followed::add)
            .forEach(sash -> {
              sash.setEnabled(!locked);
              sash.addListener(SWT.Selection, s -> getDisplay().timerExec(SETTLED_MILLIS, settled));
            });
      }
    }));
  }

  private void update(Layout layout, List<Integer> place) {
    switch (layout) {
      case Layout.Split split -> {
        forms.get(place).setWeights(weights(split));
        for (int i = 0; i < split.parts().size(); i++) {
          update(split.parts().get(i), within(place, i));
        }
      }
      case Layout.Tabs tabs -> stacks.stream().filter(stack -> stack.ids().equals(tabs.uics())).findFirst()
          .ifPresent(stack -> stack.choose(tabs.front()));
      case Layout.View view -> {}
    }
  }

  private static List<Integer> within(List<Integer> place, int index) {
    return Stream.concat(place.stream(), Stream.of(index)).toList();
  }

  private static int[] weights(Layout.Split split) {
    double all = split.weights().stream().mapToDouble(w -> w).sum();
    return split.weights().stream().mapToInt(w -> (int) Math.max(1, Math.round(UNITS * w / all))).toArray();
  }

  /** Whether splits stay as they are divided. */
  void lock(boolean now) {
    locked = now;
    forms.values().forEach(form -> Stream.of(form.getChildren()).filter(Sash.class::isInstance)
        .forEach(sash -> sash.setEnabled(!now)));
  }

  /** Has a stack take the whole window, or all have their places again. */
  void maximize(Optional<ViewStack> stack) {
    maximized = stack.filter(s -> stacks.size() > 1);
    forms.values().forEach(form -> form.setMaximizedControl(null));
    maximized.ifPresent(s -> {
      for (Control at = s; at != this; at = at.getParent()) {
        if (at.getParent() instanceof SashForm form) {
          form.setMaximizedControl(at);
        }
      }
    });
    stacks.forEach(s -> s.maximized(maximized.filter(m -> m == s).isPresent()));
  }

  Optional<ViewStack> maximized() {
    return maximized;
  }

  /** The stack under a point of the display. */
  Optional<ViewStack> stackAt(Point at) {
    return stacks.stream().filter(stack -> stack.isVisible() && place(stack).contains(toControl(at))).findFirst();
  }

  /** Where a stack lies in the tree. */
  Rectangle place(ViewStack stack) {
    Point size = stack.getSize();
    return getDisplay().map(stack, this, new Rectangle(0, 0, size.x, size.y));
  }

  /** Its content takes all of it; the frame lies where it is put. */
  private static final class Whole extends org.eclipse.swt.widgets.Layout {
    @Override
    protected Point computeSize(Composite composite, int width, int height, boolean flushCache) {
      return new Point(Math.max(width, 100), Math.max(height, 100));
    }

    @Override
    protected void layout(Composite composite, boolean flushCache) {
      Stream.of(composite.getChildren()).filter(child -> !(child instanceof Aside))
          .forEach(child -> child.setBounds(composite.getClientArea()));
    }
  }
}
