package org.robotui.uic.plot.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.io.StringWriter;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.robotui.uic.plot.internal.trace.Samples;
import org.robotui.uic.plot.internal.trace.Series;
import org.robotui.uic.plot.internal.trace.TimeSpan;

class CsvExportTest {
  private static final long SECOND = TimeSpan.SECOND;

  @Test
  void tracesAreMergedByTime() throws IOException {
    assertEquals("""
        time [s],a.b:x [m/s],"scale(a.b:y, 2)"
        1.000000000,0.1,5
        1.500000000,,6.25
        2.000000000,-3,
        """, written(new TimeSpan(SECOND, 2 * SECOND), column("a.b:x", "m/s", 0, 9, 1, 0.1, 2, -3, 3, 9),
        column("scale(a.b:y, 2)", "", 1, 5, 1.5, 6.25)));
  }

  @Test
  void breaksMakeNoRowAndInfinityIsANumber() throws IOException {
    assertEquals("""
        time [s],x
        1.000000000,1
        3.000000000,Infinity
        """, written(new TimeSpan(0, 9 * SECOND), column("x", "", 1, 1, 2, Double.NaN, 3, Double.POSITIVE_INFINITY)));
  }

  @Test
  void severalSamplesOfOneTimeMakeSeveralRows() throws IOException {
    assertEquals("time [s],x\n1.000000000,1\n1.000000000,2\n",
        written(new TimeSpan(0, 9 * SECOND), column("x", "", 1, 1, 1, 2)));
  }

  @Test
  void numbersAreTheSameInAllLanguages() throws IOException {
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
      assertEquals("time [s],x\n1234.500000000,1.0E-10\n",
          written(new TimeSpan(0, 9999 * SECOND), column("x", "", 1234.5, 1e-10)));
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void anInterruptEndsTheExport() {
    Thread.currentThread().interrupt();
    assertThrows(IOException.class, () -> written(new TimeSpan(0, 9 * SECOND), column("x", "", 1, Double.NaN, 2, 3)));
    assertEquals(true, Thread.interrupted());
  }

  private static String written(TimeSpan span, CsvExport.Column... columns) throws IOException {
    StringWriter out = new StringWriter();
    new CsvExport(List.of(columns), span).write(out);
    return out.toString();
  }

  private static CsvExport.Column column(String name, String unit, double... secondsAndValues) {
    Series series = new Series(1000);
    for (int i = 0; i < secondsAndValues.length; i += 2) {
      series.add(TimeSpan.nanos(secondsAndValues[i]), secondsAndValues[i + 1]);
    }
    Samples samples = series.samples();
    return new CsvExport.Column(name, unit, samples);
  }
}
