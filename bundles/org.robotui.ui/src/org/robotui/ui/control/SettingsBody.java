package org.robotui.ui.control;

import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Label;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * Makes the widgets of settings, of what is open only. They are made anew when a group opens or closes, or an item
 * comes, goes or moves. Display thread.
 */
final class SettingsBody {
  private final Composite root;
  private final Theme theme;
  private final FormCells cells;
  private final Runnable changed;
  private final Map<SettingNode, SettingRow> rows = new IdentityHashMap<>();
  private final Map<SettingNode, Control> heads = new IdentityHashMap<>();
  private final Set<SettingNode> turned = Collections.newSetFromMap(new IdentityHashMap<>());
  private List<SettingNode> nodes = List.of();

  /** Tells after each change, also of what is seen. */
  SettingsBody(Composite root, Theme theme, Runnable changed) {
    this.root = root;
    this.theme = theme;
    this.changed = changed;
    this.cells = new FormCells(root, theme);
  }

  void show(List<SettingNode> settings) {
    nodes = settings;
    turned.clear();
    build();
  }

  /** Opens what is wrong, and puts the cursor there. */
  void focus(SettingNode node) {
    for (SettingNode at : nodes) {
      reveal(at, node, 0);
    }
    build();
    seek(node);
  }

  private boolean reveal(SettingNode at, SettingNode wanted, int depth) {
    boolean within = at.nodes().stream().filter(n -> reveal(n, wanted, depth + 1)).count() > 0;
    if (within && !isOpen(at, depth)) {
      turn(at);
    }
    return within || at == wanted;
  }

  private void seek(SettingNode node) {
    Optional<SettingRow> row = Optional.ofNullable(rows.get(node));
    row.ifPresentOrElse(SettingRow::focus,
        () -> Optional.ofNullable(heads.get(node)).ifPresent(Control::setFocus));
  }

  private void build() {
    root.setRedraw(false);
    rows.clear();
    heads.clear();
    for (Control child : root.getChildren()) {
      child.dispose();
    }
    nodes.forEach(n -> node(n, n.name(), 0, Optional.empty()));
    root.setRedraw(true);
  }

  private void node(SettingNode node, String name, int depth, Optional<SettingNode> list) {
    if (node.shape() instanceof SettingShape.Line) {
      line(node, name, depth, list);
    } else if (head(node, name, depth, list)) {
      int index = 0;
      Optional<SettingNode> owner = Optional.of(node).filter(n -> n.shape() instanceof SettingShape.Many);
      for (SettingNode part : node.nodes()) {
        node(part, part.title(index++), depth + 1, owner);
      }
      owner.ifPresent(many -> adding(many, depth + 1));
    }
  }

  private void line(SettingNode node, String name, int depth, Optional<SettingNode> list) {
    Label label = cells.name(depth, name);
    label.setToolTipText(HelpText.of(node.setting()).replace("&", "&&"));
    boolean menu = hasMenu(node, list);
    Composite line = cells.editor(menu ? 2 : 1);
    rows.put(node, new SettingRow(cells.part(line), theme, node, () -> typed(node)));
    if (menu) {
      more(line, node, name, list);
    }
  }

  /** Others may have another form now: then the field in which it was typed is made anew as well, once it is done. */
  private void typed(SettingNode node) {
    if (nodes.stream().filter(SettingNode::follow).count() > 0) {
      root.getDisplay().asyncExec(() -> {
        if (!root.isDisposed()) {
          rebuild(node);
        }
      });
    }
    changed.run();
  }

  private boolean head(SettingNode node, String name, int depth, Optional<SettingNode> list) {
    boolean open = isOpen(node, depth);
    boolean menu = hasMenu(node, list);
    QuietButton head = cells.head(depth, name, name, open, menu ? 3 : 2, () -> {
      turn(node);
      rebuild(node);
    });
    heads.put(node, head);
    List<FormProblem> problems = node.problems("");
    boolean telling = !problems.isEmpty() && !open;
    String words = node.isItem() ? open ? "" : node.summary()
        : node.summary().isEmpty() ? HelpText.of(node.setting())
            : node.summary() + "  \u00b7  " + HelpText.of(node.setting());
    Optional<String> own = node.problem();
    cells.note(head.getParent(), telling ? problems.getFirst().sentence() : own.orElse(words),
        telling || own.isPresent() ? Role.BAD : Role.DIM);
    if (menu) {
      more(head.getParent(), node, name, list);
    }
    return open;
  }

  private static boolean hasMenu(SettingNode node, Optional<SettingNode> list) {
    return list.isPresent() || SettingShape.offered(node.setting().type()).size() > 1;
  }

  private void more(Composite line, SettingNode node, String name, Optional<SettingNode> list) {
    QuietButton[] button = new QuietButton[1];
    button[0] = cells.button(line, Icon.MORE, "Rename, move or remove " + name, () -> menu(button[0], node, list));
    ((GridData) button[0].getLayoutData()).horizontalAlignment = SWT.END;
  }

  private void menu(QuietButton button, SettingNode node, Optional<SettingNode> list) {
    PopupMenu menu = new PopupMenu(button);
    list.ifPresent(many -> {
      int at = many.nodes().indexOf(node);
      if (isNamed(many)) {
        menu.push("Rename\u2026", () -> name(many, "New name", node.name())
            .ifPresent(n -> change(node, () -> node.rename(n))));
      }
      menu.push("Move Up", at > 0, () -> change(node, () -> many.move(node, -1)));
      menu.push("Move Down", at < many.nodes().size() - 1, () -> change(node, () -> many.move(node, 1)));
      menu.push("Remove", () -> change(many, () -> many.remove(node)));
      menu.line();
    });
    List<SettingShape> shapes = SettingShape.offered(node.setting().type());
    if (shapes.size() > 1) {
      shapes.forEach(s -> menu.radio(s.words(), s.equals(node.shape()), () -> change(node, () -> node.reshape(s))));
    }
    menu.openBelow(button);
  }

  private void adding(SettingNode many, int depth) {
    cells.name(depth, "");
    QuietButton button = cells.button(cells.editor(1), Icon.PLUS, "Add to " + many.name(), () -> add(many));
    button.text("Add");
  }

  private void add(SettingNode many) {
    Optional<String> name = isNamed(many) ? name(many, "Name", "") : Optional.of("");
    name.ifPresent(n -> {
      SettingNode added = many.add(n);
      if (!isOpen(added, 1)) {
        turn(added);
      }
      change(added.shape() instanceof SettingShape.Group ? added.nodes().stream().findFirst().orElse(added) : added,
          () -> {});
    });
  }

  private static boolean isNamed(SettingNode many) {
    return many.shape() instanceof SettingShape.Many m && m.named();
  }

  private Optional<String> name(SettingNode many, String title, String before) {
    Set<String> taken = new HashSet<>(many.nodes().stream().map(SettingNode::name).toList());
    taken.remove(before);
    return NameDialog.ask(root, title, before, words -> !words.isBlank() && !taken.contains(words.strip()));
  }

  private void change(SettingNode next, Runnable action) {
    action.run();
    rebuild(next);
  }

  private void rebuild(SettingNode next) {
    build();
    changed.run();
    seek(next);
  }

  /** Groups among items are closed, as each has many fields. */
  private boolean isOpen(SettingNode node, int depth) {
    boolean first = node.shape() instanceof SettingShape.Many ? nodes.size() == 1 || !node.nodes().isEmpty()
        : depth == 0 && node.value().isPresent();
    return first != turned.contains(node);
  }

  private void turn(SettingNode node) {
    if (!turned.remove(node)) {
      turned.add(node);
    }
  }
}
