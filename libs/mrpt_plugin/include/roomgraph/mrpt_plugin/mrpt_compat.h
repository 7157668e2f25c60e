#pragma once

// The only place that knows which of MRPT's names changed between its versions: MRPT 3 moved the
// 3D objects from mrpt::opengl to mrpt::viz and calls the scene Scene.

#if __has_include(<mrpt/viz/Scene.h>)
#include <mrpt/viz/CDisk.h>
#include <mrpt/viz/CPointCloud.h>
#include <mrpt/viz/CSetOfLines.h>
#include <mrpt/viz/CSetOfObjects.h>
#include <mrpt/viz/CSetOfTriangles.h>
#include <mrpt/viz/CText3D.h>
#include <mrpt/viz/CTexturedPlane.h>
#include <mrpt/viz/Scene.h>
#include <mrpt/viz/Visualizable.h>
namespace roomgraph {
namespace viz = mrpt::viz;
using MrptScene = viz::Scene;
}  // namespace roomgraph
#else
#include <mrpt/opengl/CDisk.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CText3D.h>
#include <mrpt/opengl/CTexturedPlane.h>
#include <mrpt/opengl/Visualizable.h>
namespace roomgraph {
namespace viz = mrpt::opengl;
using MrptScene = viz::COpenGLScene;
}  // namespace roomgraph
#endif

#include <mrpt/core/Stringifyable.h>
#include <mrpt/serialization/CArchive.h>
#include <mrpt/serialization/CSerializable.h>
