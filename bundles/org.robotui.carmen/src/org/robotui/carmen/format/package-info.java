/**
 * The format language of IPC: how messages say what they consist of, as text ({@code {int,<double:1>,string}}) and as
 * it is sent by a central. Nothing here blocks; what peers sent is bounded in depth and size, and a
 * {@link org.robotui.carmen.format.IpcFormatException} says what is wrong with it.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.carmen.format;
