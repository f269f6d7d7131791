package org.robotui.uic.jointcontrol.internal.model;

import org.robotui.ui.Figures;

/** What a bar shows, in words. Pure. */
final class RangeWords {
  private RangeWords() {}

  static String of(JointRow row) {
    Measure measure = row.measure();
    String commanded = row.hasReference() ? measure.position(row.state().reference().position()) : Figures.UNKNOWN;
    String limits = row.span().limited()
        ? "limits " + measure.position(row.span().lower()) + " to " + measure.position(row.span().upper())
        : "no limits";
    return "Measured " + measure.position(row.state().measured().position()) + ", commanded " + commanded + ", "
        + limits;
  }
}
