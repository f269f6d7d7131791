package org.robotui.uic.topics.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.RowList;
import org.robotui.ui.control.RowLook;
import org.robotui.uic.topics.internal.model.Described;
import org.robotui.uic.topics.internal.model.Fact;
import org.robotui.uic.topics.internal.model.Key;

/** What is known of the selected thing: its facts, with links, and the definition of its type. Display thread. */
final class AboutPane {
  private static final int LABEL = 104;
  private static final int MOST_FACTS = 10;

  private final Composite root;
  private final RowList<Fact> facts;
  private final DefinitionText definition;
  private final Composite rule;
  private List<Fact> shown = List.of();
  private boolean defined;

  AboutPane(Composite parent, Theme theme, Consumer<Key> follow) {
    root = Boxes.panel(parent, theme, 1);
    facts = new RowList<>(root, theme, new FactLook(theme)).named("Facts");
    facts.control().setLayoutData(Boxes.fill());
    facts.onOpen(fact -> fact.target().ifPresent(follow));
    facts.control().addListener(SWT.MouseUp, e -> {
      if (e.button == 1 && e.x >= LABEL && e.count == 1) {
        facts.selected().stream().findFirst().flatMap(Fact::target).ifPresent(follow);
      }
    });
    facts.menu(rows -> List.of());
    rule = Boxes.rule(root, theme);
    definition = new DefinitionText(root, theme);
    definition.control().setLayoutData(Boxes.fill());
    root.addListener(SWT.Resize, e -> arrange());
    arrange();
  }

  Control control() {
    return root;
  }

  RowList<Fact> facts() {
    return facts;
  }

  void show(Described described) {
    boolean changed = !shown.equals(described.facts());
    if (changed) {
      shown = described.facts();
      facts.show(shown);
    }
    message(described);
    Optional<String> text = described.description().flatMap(d -> d.definition());
    definition.show(text.orElse(""));
    if (changed || defined != text.isPresent()) {
      defined = text.isPresent();
      arrange();
    }
  }

  private void message(Described described) {
    String robot = described.key().robot();
    if (!described.facts().isEmpty()
        || described.description().isPresent() && described.failure().isEmpty() && defined) {
      facts.noMessage();
    } else if (described.failure().isPresent()) {
      facts.message(Health.BAD, "No answer", described.failure().get());
    } else if (described.description().isEmpty()) {
      facts.message(Health.WAITING, "Asking " + robot, "");
    } else {
      facts.message(Health.NONE, "Nothing more is known", robot + " has no further details of it.");
    }
  }

  /** The facts take the room they need, up to a half; the definition has the rest. */
  private void arrange() {
    GridData data = (GridData) facts.control().getLayoutData();
    int needed = Math.clamp(shown.size(), 1, MOST_FACTS) * RowLook.HEIGHT + Theme.STEP;
    data.grabExcessVerticalSpace = !defined;
    data.heightHint =
        defined ? Math.min(needed, Math.max(RowLook.HEIGHT, root.getClientArea().height / 2)) : SWT.DEFAULT;
    Boxes.seen(rule, defined);
    Boxes.seen(definition.control(), defined);
    root.layout();
  }

  /** A fact: what it is, and what it says. */
  private static final class FactLook implements RowLook<Fact> {
    private final Theme theme;

    FactLook(Theme theme) {
      this.theme = theme;
    }

    @Override
    public Object key(Fact fact) {
      return fact.number();
    }

    @Override
    public String text(Fact fact) {
      return fact.label().isEmpty() ? fact.value() : fact.label() + "\t" + fact.value();
    }

    @Override
    public void paint(GC gc, Rectangle at, Fact fact) {
      gc.setFont(theme.font(Face.BODY));
      gc.setForeground(theme.color(Role.DIM));
      int left = at.x + Theme.EDGE;
      String label = TextFit.shorten(gc, fact.label(), LABEL - 2 * Theme.STEP);
      int y = at.y + (at.height - gc.textExtent("X").y) / 2;
      gc.drawText(label, left, y, true);
      gc.setForeground(theme.color(fact.target().isPresent() ? Role.ACCENT : Role.TEXT));
      gc.drawText(TextFit.shorten(gc, fact.value(), at.width - LABEL - 2 * Theme.EDGE), left + LABEL, y, true);
    }

    @Override
    public String hint(GC gc, Rectangle at, Fact fact, int x) {
      gc.setFont(theme.font(Face.BODY));
      return gc.textExtent(fact.value()).x > at.width - LABEL - 2 * Theme.EDGE ? fact.value() : "";
    }
  }
}
