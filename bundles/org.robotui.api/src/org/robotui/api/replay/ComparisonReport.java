package org.robotui.api.replay;

import java.util.List;

/**
 * How far two recordings are apart.
 *
 * @param pairs how many values belong together
 * @param first how many the first recording has
 * @param second how many the other one has
 * @param errors each kind of error
 * @param problems what could not be read, a sentence each; empty where all is well
 */
public record ComparisonReport(int pairs, int first, int second, List<ComparedError> errors, List<String> problems) {
  /**
   * Copies the lists.
   *
   * @param pairs how many values belong together
   * @param first how many the first recording has
   * @param second how many the other one has
   * @param errors each kind of error
   * @param problems sentences
   */
  public ComparisonReport {
    errors = List.copyOf(errors);
    problems = List.copyOf(problems);
  }

  /**
   * Errors of one kind.
   *
   * @param name what is compared, for users
   * @param unit of all figures but the count; empty where it is not known
   * @param count how many there are
   * @param rmse root of the mean of their squares
   * @param mean their mean
   * @param median the middle one
   * @param deviation their standard deviation
   * @param least the smallest one
   * @param most the largest one
   * @param curve all of them
   */
  public record ComparedError(String name, String unit, int count, double rmse, double mean, double median,
      double deviation, double least, double most, ErrorCurve curve) {
    /**
     * Its name for headings.
     *
     * @return with its unit, where that is known
     */
    public String title() {
      return unit.isEmpty() ? name : name + " [" + unit + "]";
    }
  }

  /**
   * All errors as comma separated values: a line for each time, with the way gone where that is known, and a column for
   * each kind of error.
   *
   * @return lines with a heading; numbers with all digits
   */
  public String csv() {
    return ErrorCurve.csv(errors);
  }
}
