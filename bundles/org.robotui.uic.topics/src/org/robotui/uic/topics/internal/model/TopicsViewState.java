package org.robotui.uic.topics.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DynamicRecord;
import org.robotui.ui.ask.Measure;

/**
 * All that the view shows, at one moment.
 *
 * @param wishes what the user wants to see
 * @param state whether there is a robot that answers
 * @param rows the list, filtered and sorted
 * @param counts how many of each kind the filter leaves
 * @param total how many of the listed kind there are
 * @param notice what is wrong although there is something to list, empty where nothing is
 * @param described what is known of the selected thing
 * @param echo the messages of the echoed topic
 * @param speech how saying messages is going
 * @param streams how many streams are asked for
 * @param messages those of a recording
 */
public record TopicsViewState(
    Wishes wishes,
    InputState state,
    List<TopicRow> rows,
    Map<Kind, Integer> counts,
    int total,
    String notice,
    Optional<Described> described,
    Echo echo,
    Speech speech,
    int streams,
    MessageListing messages) {
  /**
   * The messages of the echoed topic.
   *
   * @param source the stream, none where nothing is echoed or there is none
   * @param obstacle why there is no stream, empty where there is one or nothing is selected
   * @param state what the stream gives
   * @param shown the message that is shown
   * @param record its fields
   * @param history the newest first
   * @param count how many came since the echo began
   * @param missed how many came since it is held
   * @param measure what was measured
   */
  public record Echo(
      Optional<SourceId> source,
      String obstacle,
      InputState state,
      Optional<Heard> shown,
      Optional<DynamicRecord> record,
      List<Heard> history,
      long count,
      long missed,
      Measure measure) {
    /** Nothing is echoed. */
    public static final Echo NOTHING =
        new Echo(Optional.empty(), "", new InputState.Unconnected("nothing is selected"), Optional.empty(),
            Optional.empty(), List.of(), 0, 0, Measure.NOTHING);
  }
}
