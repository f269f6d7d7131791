package org.robotui.ui.control;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Icon;
import org.robotui.ui.Theme;

/**
 * Makes the widgets of a form, of what is open only. They are made anew when a part opens or closes, or an element
 * comes or goes. Display thread.
 */
final class FormBody {
  /** More elements are kept and sent, but not shown. */
  static final int SHOWN = 50;

  private static final int OPEN_AT_FIRST = 3;

  /** A longer array is closed at first. */
  private static final int FEW = 12;

  private final Composite root;
  private final Theme theme;
  private final FormCells cells;
  private final Runnable changed;
  private final Runnable rebuilt;
  private final Map<String, FormRow> rows = new LinkedHashMap<>();
  private final Set<String> turned = new HashSet<>();
  private Optional<FormModel> model = Optional.empty();

  FormBody(Composite root, Theme theme, Runnable changed, Runnable rebuilt) {
    this.root = root;
    this.theme = theme;
    this.changed = changed;
    this.rebuilt = rebuilt;
    this.cells = new FormCells(root, theme);
  }

  /** Another form: nothing of the last one stays. */
  void show(FormModel next) {
    model = Optional.of(next);
    turned.clear();
    build();
  }

  /** Makes all widgets anew, with what is in the model. */
  void build() {
    Optional<String> focused =
        rows.values().stream().filter(row -> row.input().isFocusControl()).map(row -> row.leaf().path()).findFirst();
    root.setRedraw(false);
    rows.clear();
    for (Control child : root.getChildren()) {
      child.dispose();
    }
    model.ifPresent(m -> m.root().fields().forEach(field -> node(field, 0, Optional.empty())));
    root.setRedraw(true);
    rebuilt.run();
    focused.map(rows::get).ifPresent(row -> row.input().setFocus());
  }

  /** Opens what a field is in, and puts the cursor there. */
  void focus(String path) {
    if (!rows.containsKey(path)) {
      model.ifPresent(m -> m.root().fields().forEach(field -> reveal(field, path, 0)));
      build();
    }
    Optional.ofNullable(rows.get(path)).ifPresent(row -> row.input().setFocus());
  }

  FormModel model() {
    return model.orElseThrow();
  }

  Map<String, FormRow> rows() {
    return rows;
  }

  private void reveal(FormNode node, String path, int depth) {
    if (!path.startsWith(node.path()) || node instanceof FormLeaf) {
      return;
    }
    if (!isOpen(node, depth)) {
      turn(node.path());
    }
    switch (node) {
      case FormGroup group -> group.fields().forEach(field -> reveal(field, path, depth + 1));
      case FormArray array -> array.elements().forEach(element -> reveal(element, path, depth + 1));
      case FormLeaf leaf -> {}
    }
  }

  private void node(FormNode node, int depth, Optional<Runnable> remove) {
    switch (node) {
      case FormLeaf leaf -> leaf(leaf, depth, remove);
      case FormGroup group -> {
        if (head(group, depth, group.shape().shape().type(), remove)) {
          group.fields().forEach(field -> node(field, depth + 1, Optional.empty()));
        }
      }
      case FormArray array -> array(array, depth, remove);
    }
  }

  private void array(FormArray array, int depth, Optional<Runnable> remove) {
    int size = array.elements().size();
    if (!head(array, depth, size + (size == 1 ? " element" : " elements"), remove)) {
      return;
    }
    for (int i = 0; i < Math.min(SHOWN, size); i++) {
      int index = i;
      node(array.elements().get(i), depth + 1,
          array.fixed() ? Optional.empty() : Optional.of(() -> change(() -> array.remove(index))));
    }
    if (size > SHOWN) {
      cells.name(depth + 1, "");
      cells.note(cells.editor(1), "and " + (size - SHOWN) + " more, sent but not shown");
    } else if (!array.fixed()) {
      cells.name(depth + 1, "");
      cells.button(cells.editor(1), Icon.PLUS, "Add to " + array.path(), () -> change(array::add)).text("Add");
    }
  }

  private void change(Runnable action) {
    action.run();
    build();
    changed.run();
  }

  private void leaf(FormLeaf leaf, int depth, Optional<Runnable> remove) {
    cells.name(depth, leaf.name()).setToolTipText(leaf.path());
    Composite line = cells.editor(remove.isPresent() ? 2 : 1);
    rows.put(leaf.path(), new FormRow(cells.part(line), theme, leaf, changed));
    remove.ifPresent(action -> cells.button(line, Icon.CLOSE, "Remove " + leaf.path(), action));
  }

  private boolean head(FormNode node, int depth, String words, Optional<Runnable> remove) {
    boolean open = isOpen(node, depth);
    Composite line = cells.head(depth, node.name(), node.path(), open, remove.isPresent() ? 3 : 2, () -> {
      turn(node.path());
      build();
    }).getParent();
    cells.note(line, words);
    remove.ifPresent(action -> cells.button(line, Icon.CLOSE, "Remove " + node.path(), action));
    return open;
  }

  private boolean isOpen(FormNode node, int depth) {
    boolean first = switch (node) {
      case FormGroup group -> depth < OPEN_AT_FIRST && !group.shape().shape().type().endsWith("/Header");
      case FormArray array -> array.elements().size() <= FEW;
      case FormLeaf leaf -> false;
    };
    return first != turned.contains(node.path());
  }

  private void turn(String path) {
    if (!turned.remove(path)) {
      turned.add(path);
    }
  }
}
