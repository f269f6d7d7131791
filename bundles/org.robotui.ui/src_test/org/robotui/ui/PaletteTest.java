package org.robotui.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.eclipse.swt.graphics.RGB;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class PaletteTest {
  private static final double LEGIBLE = 4.5;

  @Test
  void contrastIsAsDefinedByWcag() {
    assertEquals(21, Palette.contrast(new RGB(0, 0, 0), new RGB(255, 255, 255)), 1e-9);
    assertEquals(1, Palette.contrast(new RGB(9, 9, 9), new RGB(9, 9, 9)), 1e-9);
    assertEquals(4.54, Palette.contrast(new RGB(0x76, 0x76, 0x76), new RGB(255, 255, 255)), 0.01);
  }

  @ParameterizedTest
  @EnumSource(value = Role.class, names = {"TEXT", "DIM", "ACCENT", "GOOD", "WARNING"})
  void textOfTheDarkThemeIsLegibleOnAllGrounds(Role text) {
    assertLegible(Themes.darkPalette(), text);
  }

  @ParameterizedTest
  @EnumSource(value = Role.class, names = {"TEXT", "DIM", "ACCENT", "GOOD", "WARNING", "BAD", "PLAN", "SONAR"})
  void textOfTheLightThemeIsLegibleOnAllGrounds(Role text) {
    assertLegible(Themes.lightPalette(), text);
  }

  @Test
  void theDarkThemeIsTheDrawnOne() {
    Palette dark = Themes.darkPalette();
    assertEquals(new RGB(0x1b, 0x1f, 0x24), dark.rgb(Role.GROUND));
    assertEquals(new RGB(0x4d, 0xa3, 0xff), dark.rgb(Role.ACCENT));
    assertEquals(new RGB(0xff, 0x8a, 0x65), dark.rgb(Role.LASER));
  }

  @Test
  void wallsAndTracesStandOutFromFloors() {
    for (Palette p : List.of(Themes.darkPalette(), Themes.lightPalette())) {
      assertTrue(Palette.contrast(p.rgb(Role.WALL), p.rgb(Role.FLOOR)) > 2.5, p.id() + " walls");
      p.traces().forEach(t -> assertTrue(Palette.contrast(t, p.rgb(Role.PANEL)) > 3, p.id() + " trace " + t));
    }
  }

  @Test
  void aRoleWithoutColourIsRefusedByName() {
    List<RGB> traces = List.of(new RGB(1, 2, 3));
    Map<Role, RGB> few = new EnumMap<>(Map.of(Role.TEXT, new RGB(0, 0, 0)));
    Exception refused = assertThrows(IllegalArgumentException.class, () -> new Palette("mine", true, few, traces));
    assertTrue(refused.getMessage().contains("mine") && refused.getMessage().contains("GROUND"), refused.getMessage());
  }

  private static void assertLegible(Palette palette, Role text) {
    for (Role ground : List.of(Role.GROUND, Role.PANEL, Role.TITLE)) {
      double contrast = Palette.contrast(palette.rgb(text), palette.rgb(ground));
      assertTrue(contrast >= LEGIBLE, () -> palette.id() + ": " + text + " on " + ground + " is " + contrast);
    }
  }
}
