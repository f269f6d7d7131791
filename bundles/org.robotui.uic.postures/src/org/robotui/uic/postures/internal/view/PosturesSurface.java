package org.robotui.uic.postures.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.input.Numerals;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.NameDialog;
import org.robotui.ui.control.RowList;
import org.robotui.uic.postures.internal.model.Posture;
import org.robotui.uic.postures.internal.model.PostureLine;
import org.robotui.uic.postures.internal.model.PosturesLook;
import org.robotui.uic.postures.internal.model.PosturesModel;

/** What is seen of the view while it is shown: what can be done, the postures, and what is said. Display thread. */
public final class PosturesSurface implements ViewSurface {
  private final UiContext context;
  private final PosturesModel model;
  private final Composite root;
  private final PlayBar bar;
  private final RowList<PostureLine> list;
  private final PostureFiles files;
  private final AnswerLine footer;

  /** What the user chooses besides. */
  public interface Choices {
    /** Whether the first posture follows the last one. */
    void loop(boolean wanted);

    /** The share of the greatest speed. */
    void speed(double share);

    /** Does what may block. */
    void background(Runnable task);
  }

  /** Makes the controls. */
  public PosturesSurface(Composite parent, UiContext context, PosturesModel model, Choices choices) {
    this.context = context;
    this.model = model;
    root = Boxes.root(parent, context.theme(), this::focus);
    bar = new PlayBar(root, context.theme(), new PlayBar.Deeds() {
      @Override
      public void store() {
        PosturesSurface.this.store();
      }

      @Override
      public void play() {
        if (model.look().playing()) {
          model.stop();
        } else {
          model.play(0);
        }
        pressed();
      }

      @Override
      public void loop(boolean wanted) {
        choices.loop(wanted);
        pressed();
      }

      @Override
      public void guide(boolean wanted) {
        model.guide(wanted);
        pressed();
      }

      @Override
      public void speed(double share) {
        choices.speed(share);
        again();
      }
    });
    PostureColumns columns = new PostureColumns(context.theme());
    columns.heading(root);
    list = new RowList<>(root, context.theme(), columns).named("Postures").menu(this::menu)
        .onOpen(line -> act(line.index(), model::goTo));
    list.control().setLayoutData(Boxes.fill());
    list.control().addListener(SWT.KeyDown, this::key);
    footer = new AnswerLine(root, context.theme(), model.control(), this::pressed);
    files = new PostureFiles(root, model, choices::background, this::again);
    root.addListener(SWT.Resize, e -> root.getDisplay().asyncExec(this::refresh));
  }

  private boolean focus() {
    return list.control().setFocus();
  }

  @Override
  public Control control() {
    return root;
  }

  /** Files of postures. */
  public PostureFiles files() {
    return files;
  }

  /** Shows what the last tick prepared. */
  public void refresh() {
    if (root.isDisposed()) {
      return;
    }
    PosturesLook now = model.look();
    context.note(now.note());
    bar.show(now);
    list.show(now.lines());
    if (now.lines().isEmpty()) {
      list.message(Health.NONE, "No postures",
          "Bring the joints where you want them \u2013 by joint control, by hand, by a plugin \u2013 and store that.");
    } else {
      list.noMessage();
    }
    list.redraw();
    footer.show(now);
  }

  /** Selects a posture by its place. */
  public void select(int index) {
    list.select(index);
    refresh();
  }

  RowList<PostureLine> list() {
    return list;
  }

  PlayBar bar() {
    return bar;
  }

  AnswerLine footer() {
    return footer;
  }

  private void again() {
    model.fresh();
    refresh();
  }

  private void pressed() {
    focus();
    again();
  }

  private void store() {
    Optional<Integer> stored = model.store();
    again();
    stored.ifPresent(list::select);
    focus();
  }

  private void key(Event event) {
    int modifiers = event.stateMask & SWT.MODIFIER_MASK;
    if (event.keyCode == SWT.INSERT) {
      store();
    } else if (event.keyCode == SWT.ESC) {
      model.stop();
    } else if (event.keyCode == 'z' && modifiers == SWT.MOD1) {
      model.undo();
    } else {
      selected().ifPresent(index -> key(event.keyCode, modifiers, index));
    }
    again();
  }

  private void key(int code, int modifiers, int index) {
    if (code == SWT.DEL) {
      model.remove(index);
    } else if (code == SWT.F2) {
      rename(index);
    } else if (modifiers == SWT.ALT && (code == SWT.ARROW_UP || code == SWT.ARROW_DOWN)) {
      move(index, code == SWT.ARROW_UP ? -1 : 1);
    }
  }

  private Optional<Integer> selected() {
    return list.selected().stream().findFirst().map(PostureLine::index);
  }

  private List<ViewAction> menu(List<PostureLine> lines) {
    List<ViewAction> actions = new ArrayList<>();
    lines.stream().findFirst().map(PostureLine::index).ifPresent(index -> {
      if (model.look().blocked().isEmpty()) {
        actions.add(action("go", "Go to it\tEnter", Icon.TARGET, index, model::goTo));
        actions.add(action("from", "Run from here", Icon.PLAY, index, model::play));
      }
      actions.add(action("name", "Rename\u2026\tF2", Icon.TEXT, index, this::rename));
      actions.add(action("time", "Duration\u2026", Icon.GEAR, index, this::time));
      actions.add(action("again", "Store the present posture here", Icon.RESTART, index, model::again));
      actions.add(action("earlier", "Earlier\tAlt+Up", Icon.STEP_BACK, index, i -> move(i, -1)));
      actions.add(action("later", "Later\tAlt+Down", Icon.STEP_FORWARD, index, i -> move(i, 1)));
      actions.add(action("remove", "Remove\tDelete", Icon.MINUS, index, model::remove));
    });
    return actions;
  }

  private ViewAction action(String id, String label, Icon icon, int index, IntConsumer deed) {
    return new ViewAction(id, label, icon.id(), Optional.empty(), () -> act(index, deed));
  }

  private void act(int index, IntConsumer deed) {
    deed.accept(index);
    again();
  }

  private void move(int index, int by) {
    model.move(index, by);
    again();
    if (index + by >= 0 && index + by < model.look().lines().size()) {
      list.select(index + by);
    }
  }

  private void rename(int index) {
    posture(index).flatMap(posture -> NameDialog.ask(root, "Name of the posture", posture.name()))
        .ifPresent(name -> model.rename(index, name));
  }

  private void time(int index) {
    posture(index)
        .flatMap(posture -> NameDialog.ask(root, "Seconds that the way to it takes, at least",
            Numerals.text(posture.seconds()), words -> seconds(words).isPresent()))
        .flatMap(PosturesSurface::seconds).ifPresent(seconds -> model.time(index, seconds));
  }

  private static Optional<Double> seconds(String words) {
    return Numerals.decimal(words.strip()).filter(s -> s >= Posture.SHORTEST && s <= Posture.LONGEST);
  }

  private Optional<Posture> posture(int index) {
    return model.look().lines().stream().filter(line -> line.index() == index).findFirst().map(PostureLine::posture);
  }
}
