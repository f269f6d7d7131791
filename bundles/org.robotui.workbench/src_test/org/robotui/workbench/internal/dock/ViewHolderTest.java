package org.robotui.workbench.internal.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.api.host.RuicState;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class ViewHolderTest {
  private final Shell shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
  private final Theme theme = Themes.dark(shell.getDisplay());
  private final PaintedView map = new PaintedView("follow");
  private final FakeRuic ruic = new FakeRuic("Keira").in(RuicState.SELECTED, "").view("map", map);
  private final ViewHolder holder = new ViewHolder(shell, theme, ruic, "map");
  private final List<String> told = new ArrayList<>();

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void aViewThatIsGoneTellsItsTitleLineNothing() {
    holder.into(shell, line -> told.add(line.noteText()));
    holder.note("30 Hz");
    holder.dispose();
    holder.note("stale");
    assertEquals(List.of("30 Hz"), told);
  }

  @Test
  void whatAViewHasMadeBelongsToItAndAnotherControlToNone() {
    holder.showInstance(ruic.snapshot());
    assertEquals(Optional.of(new SeenView("Keira", "map", map.control)), SeenView.of(map.control));
    assertEquals(Optional.empty(), SeenView.of(holder));
    assertEquals(Optional.empty(), SeenView.of(shell));
  }
}
