/**
 * Types of messages of Gazebo, by their names and numbers of fields: those that are known here, and those of files in a
 * search path ({@code .proto}, and sets of descriptors). Needed by who looks into messages; nodes do without.
 */
package org.robotui.gazebo.types;
