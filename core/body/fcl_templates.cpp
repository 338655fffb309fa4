// The part of FCL that query_fcl.cpp needs, compiled from FCL's headers.
//
// FCL 0.7 is made of templates, which its headers define. They leave the instances for double to libfcl,
// which holds those for all shapes and trees, and needs libccd and OctoMap. The instances for triangles and
// balls are 0.1 MB of code and need nothing. So they are made here, and libfcl is not linked. Nine members of
// two classes are not templates: a triangle is its three points, and a node of the tree numbers its children
// as BV_node_base.h says.
#include <fcl/common/types.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/geometry/shape/utility.h>
#include <fcl/math/bv/utility.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_triangle.h>
#include <fcl/narrowphase/detail/traversal/traversal_recurse.h>

namespace fcl {

using V = Vector3<double>;
using M = Matrix3<double>;
using T = Transform3<double>;

Triangle::Triangle() = default;
Triangle::Triangle(std::size_t a, std::size_t b, std::size_t c) { set(a, b, c); }
void Triangle::set(std::size_t a, std::size_t b, std::size_t c) { vids[0] = a, vids[1] = b, vids[2] = c; }
std::size_t Triangle::operator[](int k) const { return vids[k]; }
std::size_t& Triangle::operator[](int k) { return vids[k]; }

bool BVNodeBase::isLeaf() const { return first_child < 0; }
int BVNodeBase::primitiveId() const { return -first_child - 1; }
int BVNodeBase::leftChild() const { return first_child; }
int BVNodeBase::rightChild() const { return first_child + 1; }

template class AABB<double>;
template class OBB<double>;
template class RSS<double>;
template class OBBRSS<double>;
template class CollisionGeometry<double>;
template class ShapeBase<double>;
template class Sphere<double>;
template struct Contact<double>;
template struct CostSource<double>;
template struct CollisionRequest<double>;
template struct CollisionResult<double>;
template struct DistanceRequest<double>;
template struct DistanceResult<double>;

// Boxes and rectangle swept spheres around points.
template bool obbDisjoint<double>(const M&, const V&, const V&, const V&);
template double rectDistance<double>(const M&, const V&, const double*, const double*, V*, V*);
template bool inVoronoi<double>(double, double, double, double, double, double, double);
template void segCoords<double>(double&, double&, double, double, double, double, double);
template void clipToRange<double>(double&, double, double);
template OBB<double> merge_largedist<double>(const OBB<double>&, const OBB<double>&);
template OBB<double> merge_smalldist<double>(const OBB<double>&, const OBB<double>&);
template void computeVertices<double>(const OBB<double>&, V*);
template M generateCoordinateSystem<double>(const V&);
template void axisFromEigen<double>(const M&, const V&, M&);
template void eigen_old<double>(const M&, V&, M&);
template void getCovariance<double>(const V*, const V*, Triangle*, unsigned*, int, M&);
template void getExtentAndCenter<double>(const V*, const V*, Triangle*, unsigned*, int, const M&, V&, V&);
template void getRadiusAndOriginAndRectangleSize<double>(const V*, const V*, Triangle*, unsigned*, int,
                                                         const M&, V&, double*, double&);

namespace detail {

template void getExtentAndCenter_mesh<double>(const V*, const V*, Triangle*, unsigned*, int, const M&, V&,
                                              V&);
template void getExtentAndCenter_pointcloud<double>(const V*, const V*, unsigned*, int, const M&, V&, V&);
namespace OBB_fit_functions {
template void fit1<double>(const V*, OBB<double>&);
template void fit2<double>(const V*, OBB<double>&);
template void fit3<double>(const V*, OBB<double>&);
template void fitn<double>(const V*, int, OBB<double>&);
}  // namespace OBB_fit_functions
namespace RSS_fit_functions {
template void fit1<double>(const V*, RSS<double>&);
template void fit2<double>(const V*, RSS<double>&);
template void fit3<double>(const V*, RSS<double>&);
template void fitn<double>(const V*, int, RSS<double>&);
}  // namespace RSS_fit_functions
namespace OBBRSS_fit_functions {
template void fit1<double>(const V*, OBBRSS<double>&);
template void fit2<double>(const V*, OBBRSS<double>&);
template void fit3<double>(const V*, OBBRSS<double>&);
template void fitn<double>(const V*, int, OBBRSS<double>&);
}  // namespace OBBRSS_fit_functions

template struct Fitter<double, OBBRSS<double>>;
template struct ComputeBVImpl<double, AABB<double>, Sphere<double>>;

// A ball and a triangle.
template bool sphereTriangleDistance<double>(const Sphere<double>&, const T&, const V&, const V&, const V&,
                                             const T&, double*, V*, V*);
template bool sphereTriangleDistance<double>(const Sphere<double>&, const T&, const V&, const V&, const V&,
                                             double*, V*, V*);
template bool sphereTriangleDistance<double>(const Sphere<double>&, const T&, const V&, const V&, const V&,
                                             double*);
template bool sphereTriangleIntersect<double>(const Sphere<double>&, const T&, const V&, const V&, const V&,
                                              V*, double*, V*);
template bool projectInTriangle<double>(const V&, const V&, const V&, const V&, const V&);
template double segmentSqrDistance<double>(const V&, const V&, const V&, V&);
template struct Project<double>;

// The search through the tree. No search here keeps its front.
template class TraversalNodeBase<double>;
template class CollisionTraversalNodeBase<double>;
template class DistanceTraversalNodeBase<double>;
template void collisionRecurse<double>(CollisionTraversalNodeBase<double>*, int, int, BVHFrontList*);
template void distanceRecurse<double>(DistanceTraversalNodeBase<double>*, int, int, BVHFrontList*);
void updateFrontList(BVHFrontList*, int, int) {}

}  // namespace detail
}  // namespace fcl
