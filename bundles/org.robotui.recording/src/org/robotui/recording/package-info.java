/**
 * Files in which messages of robots were recorded, of whatever framework: read in order of their times, from any time,
 * and written. {@link org.robotui.recording.Recordings#open} reads MCAP and bags of ROS 1 (2.0);
 * {@link org.robotui.recording.RecordingWriter} writes MCAP; {@link org.robotui.recording.RecordingCopy} makes the one
 * of the other and whole files of damaged ones.
 *
 * <p>Times are nanoseconds since 1970, as the recorder's clock had them. Messages are bytes with the name and the
 * definition of their type; what is in them is for others. Files may come from anybody: lengths are bounded before
 * anything is allocated for them, and what is damaged is told with its place while the rest is read.
 *
 * <p>Sources: the specification of MCAP (mcap.dev/spec), "Bags/Format/2.0" of ROS, the frame and block formats of LZ4.
 */
@org.osgi.annotation.versioning.Version("2.2.0")
package org.robotui.recording;
