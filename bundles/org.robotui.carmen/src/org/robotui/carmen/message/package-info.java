/**
 * Messages of IPC as records with named fields. Their formats say what they consist of, and
 * {@link org.robotui.carmen.message.IpcForms} how the fields of CARMEN's own are called, with their units; those of
 * others are numbered. Lengths that lie are found before anything is allocated for them. Values are immutable: arrays
 * that are given out must not be changed. Safe for all threads, but for what is said to be for one.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.carmen.message;
